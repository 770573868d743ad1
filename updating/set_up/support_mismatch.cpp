#include "updating/set_up/support_mismatch.hpp"

#include "updating/places/clamp_places.hpp"
#include "updating/places/held_support.hpp"
#include "updating/places/support_line.hpp"
#include "updating/structure/edit/deck_cards.hpp"
#include "updating/structure/edit/hold_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace tapfit::effects {
namespace {

std::vector<updating::SupportDof> freed(const Where& where,
                                        const Setting& setting) {
  std::vector<updating::SupportDof> dofs;
  for (const updating::SupportPart& part :
       updating::support_parts(*setting.deck, where.nodes, where.variant)) {
    dofs.insert(dofs.end(), part.line.dofs.begin(), part.line.dofs.end());
  }
  return dofs;
}

// What the deck has.
std::vector<Where> places_freed(const Setting& setting,
                                const std::vector<std::string>& variants) {
  std::vector<Where> result;
  std::vector<std::vector<int>> groups =
      updating::support_groups(*setting.deck);
  if (groups.size() > 1) {
    std::vector<int> all;
    for (const std::vector<int>& group : groups) {
      all.insert(all.end(), group.begin(), group.end());
    }
    groups.insert(groups.begin(), all);
  }
  for (const std::vector<int>& group : groups) {
    std::size_t most = 0;
    for (const std::string& variant : variants) {
      Where where;
      where.nodes = group;
      where.variant = variant;
      const std::size_t count = freed(where, setting).size();
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
std::vector<Where> places_held(const structure::Deck& deck) {
  std::vector<Where> result;
  for (const std::vector<int>& nodes : updating::clamp_places(deck)) {
    std::string known;  // what holds no more is the same under another name
    for (const std::string& variant : {hinge, clamp}) {
      if (variant == clamp && !has_turns(deck, nodes)) continue;
      Where where;
      where.nodes = nodes;
      where.variant = variant;
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

}  // namespace

std::vector<std::string> SupportMismatch::variants() const {
  std::vector<std::string> all = updating::freed_variants();
  all.insert(all.end(), {clamp, hinge});
  return all;
}

std::vector<std::string> SupportMismatch::forms() const {
  std::vector<std::string> single = updating::held_variants();
  std::erase_if(single, [](const std::string& variant) {
    return variant == clamp || variant == hinge;
  });
  return single;
}

bool SupportMismatch::takes(const std::string& form,
                            const Where& place,
                            const Setting& setting) const {
  if (place.variant != hinge) return false;
  Where where = place;
  where.variant = form;
  return !updating::newly_held(*setting.deck, where).empty();
}

std::vector<Where> SupportMismatch::places(const Setting& setting) const {
  if (setting.deck == nullptr) return {};
  std::vector<Where> supports =
      places_freed(setting, updating::freed_variants());
  return supports.empty() ? places_held(*setting.deck) : supports;
}

std::vector<structure::Constraint> SupportMismatch::released(
    const Where& where, const Setting& setting) const {
  std::vector<structure::Constraint> result;
  if (updating::is_held(where)) return result;
  for (const updating::SupportDof& dof : freed(where, setting)) {
    const std::optional<int> own =
        dof.own_axes ? dof.component
                     : card_component(*setting.deck, dof.node, dof.component);
    if (own) result.push_back({dof.node, std::to_string(*own)});
  }
  return result;
}

std::vector<std::string> SupportMismatch::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>&) const {
  if (!updating::is_held(where)) {
    return {fmt::format("$ Not held in the test: {}", describe(where))};
  }
  std::vector<structure::Constraint> fresh;
  for (const auto& grid : updating::newly_held(*setting.deck, where)) {
    fresh.push_back({grid.node, grid.components});
  }
  std::vector<std::string> cards = hold_cards(*setting.deck, fresh);
  cards.insert(cards.begin(),
               fmt::format("$ Held in the test (case control: SPC = {})",
                           constraint_set(*setting.deck)));
  return cards;
}

}  // namespace tapfit::effects
