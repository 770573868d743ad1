// Whether a file can be bulk data, told by the shape of its lines alone, so
// that nothing of another file is looked at closer, and quoted.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace tapfit::structure {

/// Counts the lines of one file that can be cards, and those that cannot. A
/// card is a name of up to eight letters and digits, and fields: without blanks
/// within them, or between commas. Comments, case control and continuations
/// say nothing.
class CardShapes {
 public:
  /// The next line as written.
  void add(const std::string& written);

  /// @param asked_by who named the file, for the message
  /// @throws InputError where most lines are no cards
  void check(const std::filesystem::path& path,
             const std::string& asked_by) const;

 private:
  std::size_t cards_ = 0;
  std::size_t others_ = 0;
  bool ended_ = false;
};

}  // namespace tapfit::structure
