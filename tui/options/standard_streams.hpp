// What the program says, and what becomes of it where nobody can read it.
#pragma once

#include <string_view>

namespace tapfit::tui {

/// To standard error. Where that cannot be written the work goes on: what is
/// said there is no result.
void say(std::string_view text);

/// A result, to standard output; control characters, which names of files may
/// hold, as "?".
/// @throws InputError where it cannot be written to its end
void print(std::string_view result);

}  // namespace tapfit::tui
