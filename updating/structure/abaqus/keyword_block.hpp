// A keyword of an Abaqus or CalculiX deck with its options and data lines.
//
// Source: Abaqus Keywords Reference Guide, "Input syntax rules"; CalculiX
// CrunchiX User's Manual, "Input deck format".
#pragma once

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// A line of a file.
struct PlacedLine {
  std::string text;
  std::string where;  ///< "file:line"
  int number = 0;
  /// Of a translated line: which of the deck's lines it comes from.
  std::size_t origin = 0;
};

/// Where a line of the deck is.
struct Place {
  std::string where;  ///< "file:line"
  int number = 0;
  std::size_t index = 0;  ///< among all lines, INCLUDE files inlined
};

/// The fields between commas, without blanks around them.
struct DataLine {
  std::vector<std::string> fields;
  Place place;
  bool continues = false;  ///< ends in a comma

  /// "" behind the last one.
  [[nodiscard]] const std::string& text(std::size_t field) const;
  /// In capitals, without quotes.
  [[nodiscard]] std::string name(std::size_t field) const;
};

struct Keyword {
  std::string name;   ///< capitals without blanks: "SOLIDSECTION"
  std::string shown;  ///< as messages say it: "SOLID SECTION"
  /// By name in capitals without blanks; values as written, without quotes.
  std::map<std::string, std::string> options;
  Place place;
  std::vector<DataLine> lines;  ///< blank ones left out
  int step = 0;                 ///< 0: the model, then the steps from 1 on

  [[nodiscard]] bool has(const std::string& option) const;
  /// In capitals; "" where it is not given.
  [[nodiscard]] std::string option(const std::string& name) const;
  /// As option().
  /// @throws InputError where it is not given
  [[nodiscard]] std::string needed_option(const std::string& name) const;
  /// An option's number; 0 where it is not given.
  [[nodiscard]] double option_number(const std::string& name) const;
  /// Data line `k`.
  /// @throws InputError where there are not as many
  [[nodiscard]] const DataLine& line(std::size_t k, const char* meaning) const;
  [[noreturn]] void fail(const std::string& what,
                         const std::string& remedy) const;
};

/// Whether the line is a keyword: `*` and a letter.
[[nodiscard]] bool is_keyword_line(const std::string& text);

/// The file that *INCLUDE, INPUT=file names.
[[nodiscard]] std::optional<std::string> included_by_keyword(
    const std::string& text);

/// Puts the lines of a deck into keywords; what stands above the first one is
/// left out, as are comments (`**`). Keyword lines continue behind a comma.
[[nodiscard]] std::vector<Keyword> keyword_blocks(
    const std::vector<PlacedLine>& lines);

/// @throws InputError "what" at the line's place
[[noreturn]] void fail_at(const Place& place,
                          const std::string& what,
                          const std::string& remedy);

/// A name or field as a message quotes it: its first characters.
[[nodiscard]] std::string shortened(const std::string& text);

/// A number with an exponent of E or D.
/// @throws InputError where the field is blank or no finite number
[[nodiscard]] double number_in(const DataLine& line,
                               std::size_t field,
                               const char* meaning);
/// As number_in(); `fallback` where the field is blank.
[[nodiscard]] double number_or(const DataLine& line,
                               std::size_t field,
                               double fallback,
                               const char* meaning);
/// x, y, z from a field on; blank ones are 0.
[[nodiscard]] Eigen::Vector3d vector_in(const DataLine& line,
                                        std::size_t first,
                                        const char* meaning);
[[nodiscard]] std::optional<int> integer_of(const std::string& text);
/// @throws InputError where the field is blank or no integer
[[nodiscard]] int integer_in(const DataLine& line,
                             std::size_t field,
                             const char* meaning);
/// A degree of freedom, 1 to 6.
/// @throws InputError for another number
[[nodiscard]] int dof_in(const DataLine& line, std::size_t field);
/// First and last degree of freedom as digits, "123"; those beyond 6 (warping,
/// pressure, temperature) are left out.
/// @throws InputError where the last is below the first, or they are beyond 1
/// to 30
[[nodiscard]] std::string dofs_in(const DataLine& line, std::size_t field);

}  // namespace tapfit::structure
