// RBE2, and RBAR; where the independent components of an RBAR are shared
// between its ends it becomes relations.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <algorithm>

namespace tapfit::structure {
namespace {

const char* const kAll = "123456";

void add_dependent(DeckBuilder& builder,
                   const CardReader& card,
                   const Dependent& dependent,
                   RigidElement& e) {
  static_cast<void>(builder.grid(card, dependent.grid));
  const bool named = std::any_of(
      e.dependents.begin(), e.dependents.end(), [&](const Dependent& d) {
        return d.grid == dependent.grid;
      });
  if (named || dependent.grid == e.independent) {
    card.fail("the element names a grid twice", "Correct the grids.");
  }
  e.dependents.push_back(dependent);
}

// The grids of a list with THRU, each once; those of THRU that exist.
std::vector<int> listed_grids(const DeckBuilder& builder,
                              const CardReader& card,
                              std::size_t first,
                              std::size_t end) {
  std::vector<int> grids;
  for (std::size_t at = first; at < end; ++at) {
    if (card.blank(at)) continue;
    if (upper(card.text(at)) != "THRU") {
      grids.push_back(card.id(at, "GM"));
      continue;
    }
    const auto [from, to] = card.range(at++, "GM");
    for (const Grid& grid : builder.deck.grids) {
      if (grid.id > from && grid.id <= to) grids.push_back(grid.id);
    }
  }
  return grids;
}

// A real at the end is the thermal expansion, which nothing here asks for.
std::size_t end_of_grids(const CardReader& card) {
  std::size_t end = card.size();
  if (end > 4 && card.text(end - 1).find('.') != std::string::npos) --end;
  return end;
}

void read_rbe2(DeckBuilder& builder, const CardReader& card) {
  auto e = claimed_by<RigidElement>(builder, card);
  e.independent = builder.grid(card, card.id(2, "GN")).id;
  const std::string components = card.components(3);
  if (components.empty()) {
    card.fail("field 4 (CM) names no component",
              "Give the components that follow, 123456 for a rigid body.");
  }
  for (const int grid : listed_grids(builder, card, 4, end_of_grids(card))) {
    add_dependent(builder, card, {grid, components}, e);
  }
  if (e.dependents.empty()) {
    card.fail("the element has no dependent grid", "Name one in field 5 (GM).");
  }
  builder.deck.rigids.push_back(e);
}

bool leads(std::string components) {
  std::sort(components.begin(), components.end());
  return components == kAll;
}

void read_rbar(DeckBuilder& builder, const CardReader& card) {
  auto e = claimed_by<RigidElement>(builder, card);
  const std::string lead_a = card.components(4);
  const std::string lead_b = card.components(5);
  const bool from_a = leads(lead_a) && lead_b.empty();
  if (!from_a && !(leads(lead_b) && lead_a.empty())) {
    read_shared_rbar(builder, card);
    return;
  }
  e.independent = builder.grid(card, card.id(from_a ? 2 : 3, "G")).id;
  std::string follow = card.components(from_a ? 7 : 6);
  if (follow.empty()) follow = kAll;
  add_dependent(builder, card, {card.id(from_a ? 3 : 2, "G"), follow}, e);
  builder.deck.rigids.push_back(e);
}

}  // namespace

CardTable rigid_cards() { return {{"RBE2", read_rbe2}, {"RBAR", read_rbar}}; }

}  // namespace tapfit::structure
