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
  auto solid = claimed_by<Solid>(builder, card);
  solid.property = property_of(card,
                               builder.deck.solid_properties,
                               card.integer_or(2, solid.id, "PID"),
                               "PSOLID");
  read_corners(builder, card, corners, edges, solid);
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
