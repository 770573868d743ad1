// What a test.json says for the reader of a report alone: limits to be kept,
// and what makes the measurement traceable.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::acquisition {

/// What model and measurement may differ by.
struct Limits {
  std::optional<double> frequency_percent = {};  ///< of each pair, at most
  std::optional<double> mac = {};                ///< of each pair, at least
  /// Off the diagonal, at most.
  std::optional<double> cross_orthogonality = {};
  /// Of each pair, at least.
  std::optional<double> cross_orthogonality_diagonal = {};
};

struct ChannelNotes {
  std::string type;  ///< of the maker
  std::string serial;
  std::string calibrated;       ///< when, as written
  std::string calibration_due;  ///< when the next is
  /// Whatever test.json says of it beyond the format, in words.
  std::vector<std::pair<std::string, std::string>> others;
};

struct TestNotes {
  Limits limits;
  std::map<std::string, ChannelNotes> channels;  ///< by name
  /// Whatever else stands at the top of test.json as a text or number, in
  /// words: {"operator", "A. Ritter"}, {"hammer tip", "nylon"},
  /// {"temperature", "21 °C"}.
  std::vector<std::pair<std::string, std::string>> facts;
};

/// @param bundle a folder with a test.json, or that file
/// @return nothing where there is none that can be read, as of a universal file
[[nodiscard]] TestNotes read_test_notes(const std::filesystem::path& bundle);

}  // namespace tapfit::acquisition
