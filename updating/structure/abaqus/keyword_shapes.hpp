// Whether a file can be (part of) an Abaqus or CalculiX deck, told by the shape
// of its lines alone, so that nothing of another file is looked at closer, and
// quoted.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace tapfit::structure {

/// Counts the lines of one file that can be keywords or data (numbers, or names
/// between commas), and those that cannot. Comments say nothing.
class KeywordShapes {
 public:
  /// The next line as written.
  void add(const std::string& written);

  /// @param asked_by who named the file, for the message
  /// @throws InputError where most lines are neither keywords nor data
  void check(const std::filesystem::path& path,
             const std::string& asked_by) const;

 private:
  std::size_t fitting_ = 0;
  std::size_t others_ = 0;
  bool in_heading_ = false;
};

/// Whether the file is such a deck: its first line that is neither blank nor a
/// comment is a keyword. In a file named .inp lines above the first keyword may
/// be anything, as both programs have it.
/// @throws InputError for what is no regular file
[[nodiscard]] bool is_keyword_deck(const std::filesystem::path& path);

}  // namespace tapfit::structure
