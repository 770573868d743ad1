// CHEXA, CPENTA, CPYRAM, CTETRA, with or without grids in the middle of their
// edges.
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

void read_solid(DeckBuilder& builder,
                const CardReader& card,
                std::size_t corners,
                std::size_t edges) {
  Solid solid;
  solid.id = card.id(1, "EID");
  solid.where = card.where();
  builder.claim(card, solid.id);
  solid.property = property_of(card,
                               builder.deck.solid_properties,
                               card.integer_or(2, solid.id, "PID"),
                               "PSOLID");
  for (std::size_t i = 0; i < corners; ++i) {
    solid.grids.push_back(existing_grid(builder, card, 3 + i));
  }
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t at = 3 + corners + i;
    const bool none = card.integer_or(at, 0, "grid") == 0;
    solid.mids.push_back(none ? 0 : existing_grid(builder, card, at));
  }
  if (std::ranges::all_of(solid.mids, [](int id) { return id == 0; })) {
    solid.mids.clear();
  }
  std::vector<int> grids = solid.all_grids();
  std::ranges::sort(grids);
  if (std::ranges::adjacent_find(grids) != grids.end()) {
    card.fail("the element names a grid twice",
              "Correct the grids; a wedge is a CPENTA, not a CHEXA with grids "
              "in common.");
  }
  if (card.size() > 3 + corners + edges) {
    card.fail(fmt::format("it names more than {} grids", corners + edges),
              "Take the last ones out.");
  }
  builder.deck.solids.push_back(solid);
}

ReadCard reader(std::size_t corners, std::size_t edges) {
  return [corners, edges](DeckBuilder& builder, const CardReader& card) {
    read_solid(builder, card, corners, edges);
  };
}

}  // namespace

CardTable solid_cards() {
  return {{"CHEXA", reader(8, 12)},
          {"CPENTA", reader(6, 9)},
          {"CPYRAM", reader(5, 8)},
          {"CPYRA", reader(5, 8)},
          {"CTETRA", reader(4, 6)}};
}

}  // namespace tapfit::structure
