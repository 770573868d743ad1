// A correction of a deck whose numbers were written down wrongly, that can be
// tried; the file stays as it is.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// One of a card's numbers, times a factor.
struct ScaledNumber {
  acquisition::UncertainProperty number;  ///< which; of it only that
  double factor = 1.0;
};

struct CardSlip {
  std::string edit;           ///< "model: PBAR 3, exchange I1 and I2"
  std::vector<int> elements;  ///< ids of those with the cards, ascending
  std::string kind;           ///< "I1-I2", one of slip_kinds()
  std::vector<ScaledNumber> numbers;
  /// By so much that the deck as it is says nothing of what it is then.
  bool from_other_unit = false;
};

/// @param card "material" or "property"
[[nodiscard]] ScaledNumber scaled_number(const std::string& card,
                                         int id,
                                         const std::string& property,
                                         double factor);

/// Whose elements are all that its numbers concern.
/// @param what cards and what to do with them, "PBAR 3, exchange I1 and I2"
[[nodiscard]] CardSlip slip_of(const structure::Deck& deck,
                               const std::string& what,
                               const std::string& kind,
                               std::vector<ScaledNumber> numbers);

/// "PBAR 3" out of "file:line PBAR 3", or what is said in its place.
[[nodiscard]] std::string card_name(const std::string& where,
                                    const std::string& other);

/// Scales its numbers in a deck.
void put_right(structure::Deck& deck, const CardSlip& slip);

}  // namespace tapfit::updating
