// Supports of the model that are not those of the test.
//
// One that the structure did not have: the test hung free, or was pinned where
// the deck clamps. What the deck holds is released and held by nothing.
//
// One that the deck does not have: the test was clamped or stood on something
// where the deck is free. What moves there is held (held_motions.hpp).
#include "updating/places/clamp_places.hpp"
#include "updating/places/held_support.hpp"
#include "updating/places/support_groups.hpp"
#include "updating/places/support_line.hpp"
#include "updating/set_up/mistakes.hpp"
#include "updating/structure/edit/deck_cards.hpp"
#include "updating/structure/edit/hold_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

namespace tapfit::effects {
namespace {

std::vector<updating::SupportDof> freed(const Location& where,
                                        const TestContext& context) {
  std::vector<updating::SupportDof> dofs;
  for (const updating::SupportPart& part :
       updating::support_parts(*context.deck, where.nodes, where.variant)) {
    dofs.insert(dofs.end(), part.line.dofs.begin(), part.line.dofs.end());
  }
  return dofs;
}

// What the deck has.
std::vector<Location> places_freed(const TestContext& context,
                                   const std::vector<std::string>& variants) {
  std::vector<Location> result;
  std::vector<std::vector<int>> groups =
      updating::support_choices(*context.deck);
  if (!groups.empty()) {
    std::rotate(groups.begin(), groups.end() - 1, groups.end());
  }
  for (const std::vector<int>& group : groups) {
    std::size_t most = 0;
    for (const std::string& variant : variants) {
      Location where{.nodes = group, .variant = variant};
      const std::size_t count = freed(where, context).size();
      // What frees all that is held is the same under another name.
      if (count == 0 || count == most) continue;
      most = std::max(most, count);
      result.push_back(std::move(where));
    }
  }
  return result;
}

const std::string clamp = "held";
const std::string hinge = "held-translations";

// @param nodes ascending
bool has_turns(const structure::Deck& deck, const std::vector<int>& nodes) {
  const auto touches = [&nodes](const auto& element) {
    return std::ranges::any_of(element.grids, [&nodes](int grid) {
      return std::ranges::binary_search(nodes, grid);
    });
  };
  return std::ranges::any_of(deck.shells, touches) ||
         std::ranges::any_of(deck.bars, touches);
}

// What it has not.
std::vector<Location> places_held(const structure::Deck& deck) {
  std::vector<Location> result;
  for (const std::vector<int>& nodes : updating::clamp_places(deck)) {
    std::string known;  // what holds no more is the same under another name
    for (const std::string& variant : {hinge, clamp}) {
      if (variant == clamp && !has_turns(deck, nodes)) continue;
      Location where{.nodes = nodes, .variant = variant};
      std::string all;
      for (const auto& grid : updating::newly_held(deck, where)) {
        all += fmt::format("{}:{} ", grid.node, grid.components);
      }
      if (all == known) continue;
      known = all;
      result.push_back(std::move(where));
    }
  }
  return result;
}

// Of what the deck holds in part, as on a hinge: all of it, where that is no
// more than half of the structure.
std::vector<Location> places_held_more(const structure::Deck& deck) {
  std::vector<Location> result;
  for (const std::vector<int>& nodes : updating::support_choices(deck)) {
    Location where{.nodes = nodes, .variant = clamp};
    const bool few = 2 * nodes.size() <= deck.grids.size();
    if (few && has_turns(deck, nodes) &&
        !updating::newly_held(deck, where).empty()) {
      result.push_back(std::move(where));
    }
  }
  return result;
}

std::vector<std::string> mismatch_variants() {
  std::vector<std::string> all = updating::freed_variants();
  all.insert(all.end(), {clamp, hinge});
  return all;
}

// Held along one axis only, where a hinge does well.
std::vector<std::string> held_along_one() {
  std::vector<std::string> single = updating::held_variants();
  std::erase_if(single, [](const std::string& variant) {
    return variant == clamp || variant == hinge;
  });
  return single;
}

class SupportMismatch final : public Effect {
 public:
  SupportMismatch()
      : Effect({.name = "support-mismatch",
                .words = "support other than in the model",
                .sits = Sits::OnLine,
                .changes_stiffness = updating::ChangeKind::Support,
                .is_mistake = true,
                .forms = held_along_one(),
                .variants = mismatch_variants()}) {}

  bool takes(const std::string& form,
             const Location& place,
             const TestContext& context) const override {
    if (place.variant != hinge) return false;
    Location where = place;
    where.variant = form;
    return !updating::newly_held(*context.deck, where).empty();
  }

  // All supports, then each connected group of constrained grids, free, free to
  // turn, and free to move along each axis; those that hold anything so; and
  // held wholly, those that hold in part. Of a deck that nothing holds each of
  // clamp_places(), held and held as by a hinge: that a structure is held
  // elsewhere than in its deck, besides, is tried by name.
  std::vector<Location> places(const TestContext& context) const override {
    if (context.deck == nullptr) return {};
    std::vector<Location> supports =
        places_freed(context, updating::freed_variants());
    if (supports.empty()) return places_held(*context.deck);
    std::ranges::move(places_held_more(*context.deck),
                      std::back_inserter(supports));
    return supports;
  }

  std::vector<structure::Constraint> released(
      const Location& where, const TestContext& context) const override {
    std::vector<structure::Constraint> result;
    if (updating::is_held(where)) return result;
    for (const updating::SupportDof& dof : freed(where, context)) {
      const std::optional<int> own =
          dof.own_axes ? dof.component
                       : card_component(*context.deck, dof.node, dof.component);
      if (own) result.push_back({dof.node, std::to_string(*own)});
    }
    return result;
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>&) const override {
    if (!updating::is_held(where)) {
      return {fmt::format("$ Not held in the test: {}", describe(where))};
    }
    std::vector<structure::Constraint> fresh;
    for (const auto& grid : updating::newly_held(*context.deck, where)) {
      fresh.push_back({grid.node, grid.components});
    }
    std::vector<std::string> cards = hold_cards(*context.deck, fresh);
    cards.insert(cards.begin(),
                 fmt::format("$ Held in the test (case control: SPC = {})",
                             constraint_set(*context.deck)));
    return cards;
  }
};

}  // namespace

const Effect& support_mismatch() {
  static const SupportMismatch effect;
  return effect;
}

}  // namespace tapfit::effects
