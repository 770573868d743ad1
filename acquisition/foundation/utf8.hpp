// Text out of files of unknown encoding; older ones are in Latin-1.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::acquisition {

/// The text in UTF-8: as it is where it is that already, else read as Latin-1.
[[nodiscard]] std::string as_utf8(std::string_view text);

/// Text of any origin for a terminal or JSON: UTF-8 as it is, bytes that are
/// none of it read as Latin-1, control characters (those that turn the
/// direction of writing, too) but line ends and tabs as "?".
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace tapfit::acquisition
