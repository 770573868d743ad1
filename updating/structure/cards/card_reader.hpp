// Typed access to the fields of a card, with errors that name file, line,
// entry and field.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"

#include <Eigen/Core>

#include <string>
#include <utility>

namespace tapfit::structure {

/// A view of one card; the card must outlive it.
class CardReader {
 public:
  explicit CardReader(const Card& card) : card_(card) {}

  /// Number of fields up to the last one that is not blank.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool blank(std::size_t field) const;
  [[nodiscard]] const std::string& text(std::size_t field) const;

  /// @throws InputError when the field is blank or not an integer
  [[nodiscard]] int integer(std::size_t field, const char* meaning) const;
  [[nodiscard]] int integer_or(std::size_t field,
                               int fallback,
                               const char* meaning) const;

  /// As `integer`, and above zero: an id.
  [[nodiscard]] int id(std::size_t field, const char* meaning) const;

  /// The ids in front of and behind the THRU of a field.
  /// @throws InputError when one is missing, or the second is below the first
  [[nodiscard]] std::pair<int, int> range(std::size_t thru,
                                          const char* meaning) const;

  /// @throws InputError when the field is blank or not a finite number
  [[nodiscard]] double real(std::size_t field, const char* meaning) const;
  [[nodiscard]] double real_or(std::size_t field,
                               double fallback,
                               const char* meaning) const;

  /// Three reals, blanks are zero.
  [[nodiscard]] Eigen::Vector3d vector(std::size_t first,
                                       const char* meaning) const;

  /// Component digits 1 to 6; blank and 0 give an empty text.
  /// @throws InputError for anything else
  [[nodiscard]] std::string components(std::size_t field) const;

  /// "file:line NAME id"
  [[nodiscard]] std::string where() const;
  [[nodiscard]] const Card& card() const { return card_; }

  /// Throws InputError with the place of the card.
  [[noreturn]] void fail(const std::string& what,
                         const std::string& remedy) const;

 private:
  const Card& card_;
};

}  // namespace tapfit::structure
