// A line of a deck of which some fields are written anew, in the columns or
// between the commas where they stand; all else stays to the byte.
//
// Source: MSC Nastran Quick Reference Guide, "Format of bulk data entries".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::structure {

class FieldLine {
 public:
  /// Bulk data, whose line tells its form: small, large or free field. Tabs
  /// become blanks where columns count.
  [[nodiscard]] static FieldLine of_card(const std::string& written);
  /// A keyword with its options, or data between commas.
  [[nodiscard]] static FieldLine of_keyword(const std::string& written);

  /// A line of bulk data that goes on behind this one, in the same form.
  [[nodiscard]] FieldLine continuation() const;

  /// Fields of bulk data in it, without its name and marker: 8 or 4.
  [[nodiscard]] std::size_t data_fields() const;
  /// Field `k`, without blanks around it; "" behind the last one. Of bulk data
  /// 0 is the name.
  [[nodiscard]] std::string field(std::size_t k) const;
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  /// A number that is wider than its columns gets as many digits as have room.
  void set(std::size_t k, const std::string& text);
  void set_name(const std::string& name);
  /// Takes out the marks by which lines find each other: two cards may not
  /// share one.
  void drop_marker();

  [[nodiscard]] std::string text() const;

 private:
  std::size_t width_ = 0;           // columns of a field; 0: between commas
  std::vector<std::string> cells_;  // with their blanks
  std::string behind_;              // a comment
};

/// A number in at most `width` characters, with point or exponent, as near as
/// they let it: of 7.1234567e10 in eight 71235.+6.
[[nodiscard]] std::string real_in(double value, std::size_t width);

}  // namespace tapfit::structure
