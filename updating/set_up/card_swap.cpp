// A number of the deck's cards that was written down wrongly: two exchanged, or
// half of a thickness in the place of the whole. No change of the deck's model
// holds what that does to its modes: the model is that of the deck put right.
#include "updating/set_up/card_slips.hpp"
#include "updating/set_up/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::effects {
namespace {

class CardSwap final : public Effect {
 public:
  CardSwap()
      : Effect({.name = "card-swap",
                .words = "numbers of the deck written down wrongly",
                .entry = Entry::Deck,
                .sits = Sits::OnElements,
                .law = Law::Own,
                .variants = updating::slip_kinds()}) {}

  std::vector<Location> places(const TestContext& context) const override {
    std::vector<Location> result;
    if (context.deck == nullptr) return result;
    for (const updating::CardSlip& slip : updating::card_slips(*context.deck)) {
      result.push_back({.elements = slip.elements, .variant = slip.kind});
    }
    return result;
  }

  void correct_deck(const Location& where,
                    structure::Deck& deck) const override {
    for (const updating::CardSlip& slip : updating::slips_at(deck, where)) {
      updating::put_right(deck, slip);
    }
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>&) const override {
    std::vector<std::string> lines;
    for (const updating::CardSlip& slip :
         updating::slips_at(*context.deck, where)) {
      lines.push_back(fmt::format("$ Put right in the {}", slip.edit));
    }
    return lines;
  }
};

}  // namespace

const Effect& card_swap() {
  static const CardSwap effect;
  return effect;
}

}  // namespace tapfit::effects
