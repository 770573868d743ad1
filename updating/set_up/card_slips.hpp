// Numbers of a deck's cards that are easily written down wrongly: two that were
// exchanged, or half of a thickness in the place of the whole. Each is a
// correction of the deck that can be tried; the file stays as it is.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

#include <functional>
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
  std::vector<int> elements;  ///< ids of those with the card, ascending
  std::string kind;           ///< "I1-I2", one of slip_kinds()
  std::vector<ScaledNumber> numbers;
  std::function<void(structure::Deck&)> correct;
};

/// In the order in which they are tried.
[[nodiscard]] const std::vector<std::string>& slip_kinds();

/// Of cards that elements use, exchanges first: I1 and I2 of bars that bend in
/// both planes, E1 and E2 of a MAT8, then the thickness of a PSHELL doubled and
/// halved. Numbers within a percent of each other are not exchanged: no
/// measurement tells.
[[nodiscard]] std::vector<CardSlip> card_slips(const structure::Deck& deck);

/// Those of the kind that is a place's variant, on its elements.
[[nodiscard]] std::vector<CardSlip> slips_at(const structure::Deck& deck,
                                             const Location& where);

}  // namespace tapfit::updating
