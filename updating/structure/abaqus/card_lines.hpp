// Lines of bulk data, each with its place in the deck that it comes from.
//
// Source: MSC Nastran Quick Reference Guide, "Format of bulk data entries".
#pragma once

#include "updating/structure/abaqus/keyword_block.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// A field of a card: text, an integer, or a real with point or exponent in at
/// most 16 characters (some ten digits). Blank where nothing is given.
struct CardField {
  CardField() = default;
  CardField(const char* written) : text(written) {}
  CardField(std::string written) : text(std::move(written)) {}
  CardField(int value);
  CardField(double value);

  std::string text;
};

using CardFields = std::vector<CardField>;

/// Adds x, y, z.
void add_vector(CardFields& fields, const Eigen::Vector3d& v);

/// A card is in small field where all of its fields have room in it, else in
/// large field.
class CardLines {
 public:
  /// `$ text`.
  void comment(const std::string& text, const Place& place);

  /// @param fields behind the name
  void card(const Place& place,
            const std::string& name,
            const CardFields& fields);

  [[nodiscard]] const std::vector<PlacedLine>& lines() const { return lines_; }

 private:
  std::vector<PlacedLine> lines_;
};

}  // namespace tapfit::structure
