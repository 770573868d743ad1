// What pages of docs/ quote: command lines and what they are said to print.
#pragma once

#include <string>
#include <vector>

namespace tapfit::end_to_end {

/// A line "    tapfit ARGUMENTS" of a page and the indented lines that follow
/// it with nothing but empty ones between.
struct QuotedCommand {
  std::string arguments;
  std::vector<std::string> printed;  ///< without empty lines
};

[[nodiscard]] std::vector<QuotedCommand> quoted_commands(
    const std::string& page);

/// The first quoted line that was not printed in its place; empty: all were.
/// Lines follow each other, but where "..." stands some may come between. Words
/// are the same, numbers to 1 % or a unit of the last digit that is quoted.
[[nodiscard]] std::string not_printed(const std::vector<std::string>& quoted,
                                      const std::string& output);

}  // namespace tapfit::end_to_end
