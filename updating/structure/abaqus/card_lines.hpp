// Lines of bulk data, each with its place in the deck that it comes from.
//
// Source: MSC Nastran Quick Reference Guide, "Format of bulk data entries".
#pragma once

#include "updating/structure/abaqus/keyword_block.hpp"

#include <span>
#include <string>
#include <vector>

namespace tapfit::structure {

/// A real with point or exponent in at most 16 characters: some ten digits.
[[nodiscard]] std::string real_field(double value);

/// A card is in small field where all of its fields have room in it, else in
/// large field.
class CardLines {
 public:
  /// `$ text`.
  void comment(const std::string& text, const Place& place = {});

  /// @param fields behind the name; blanks are empty
  void card(const Place& place,
            const std::string& name,
            const std::vector<std::string>& fields);

  /// A line as it is.
  void line(const std::string& text) { lines_.push_back({text, "", 0}); }

  [[nodiscard]] const std::vector<PlacedLine>& lines() const { return lines_; }

 private:
  std::vector<PlacedLine> lines_;
};

}  // namespace tapfit::structure
