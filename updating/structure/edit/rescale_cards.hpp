// Numbers of a deck's own cards multiplied.
#pragma once

#include "updating/structure/edit/edit_cards.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// Fields of one card that are multiplied, those left blank stay blank; or
/// that are given a value, blank or not.
struct CardScale {
  std::string name;  ///< "MAT1"
  int id = 0;        ///< first data field
  /// Positions as in Card::fields: 1 is the id.
  std::vector<std::size_t> fields;
  double factor = 1.0;
  std::optional<double> value = {};
};

/// The card with what the scales mean multiplied.
///
/// @param done one per scale, set where a number was changed
[[nodiscard]] Card rescaled(const Card& card,
                            const std::vector<CardScale>& scales,
                            std::vector<bool>& done);

/// Gives the cards that the scales mean with their numbers multiplied.
///
/// @param done one per scale, set where a number was changed; both must outlive
///   the result
[[nodiscard]] CardEdit rescale_cards(const std::vector<CardScale>& scales,
                                     std::vector<bool>& done);

}  // namespace tapfit::structure
