// Key scripts: what a user would press, in a file, replayed without a
// terminal. A line is one of
//
//   # a comment
//   wait               until all work is done
//   resize 120 35      columns and rows
//   screen             writes the screen out as text
//   anything else      keys: plain characters and <Enter>, <C-r>, <Right> ...
#pragma once

#include "tui/screen/key.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace tapfit::tui {

struct ScriptStep {
  enum class Kind { Press, Wait, Resize, Dump };
  Kind kind = Kind::Press;
  Key key;
  int width = 0;
  int height = 0;
};

/// @throws InputError with the line for a name that is no key, a size that
///   is none
[[nodiscard]] std::vector<ScriptStep> parse_key_script(std::string_view text);

/// @throws InputError also for a file that cannot be read
[[nodiscard]] std::vector<ScriptStep> read_key_script(
    const std::filesystem::path& file);

}  // namespace tapfit::tui
