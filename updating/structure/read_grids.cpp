// GRID.
#include "updating/structure/deck_builder.hpp"

#include <fmt/format.h>

namespace tapfit::structure {
namespace {

void read_grid(DeckBuilder& builder, const CardReader& card) {
  const int id = card.id(1, "ID");
  const CoordinateSystem& system =
      builder.system(card, card.integer_or(2, 0, "CP"));
  Grid grid;
  grid.id = id;
  grid.position = system.place(card.vector(3, "position"));
  if (!builder.grid_index.emplace(id, builder.deck.grids.size()).second) {
    card.fail("a grid of this id exists already", "Renumber one of the two.");
  }
  builder.deck.grids.push_back(grid);
  const std::string held = card.components(7);
  if (!held.empty()) builder.permanent.push_back({id, held});
}

void read_axes(DeckBuilder& builder, const CardReader& card) {
  const int cd = card.integer_or(6, 0, "CD");
  if (cd == 0) return;
  Grid& grid = builder.deck.grids[builder.grid_index.at(card.id(1, "ID"))];
  grid.axes = builder.system(card, cd).directions(grid.position);
}

}  // namespace

const Grid& DeckBuilder::grid(const CardReader& card, int id) const {
  const auto found = grid_index.find(id);
  if (found == grid_index.end()) {
    card.fail(fmt::format("grid {} does not exist", id),
              "Add the GRID or correct the entry.");
  }
  return deck.grids[found->second];
}

const CoordinateSystem& DeckBuilder::system(const CardReader& card,
                                            int id) const {
  static const CoordinateSystem kBasic;
  if (id == 0) return kBasic;
  const auto found = systems.find(id);
  if (found == systems.end()) {
    card.fail(fmt::format("coordinate system {} does not exist", id),
              "Add a CORD2R, CORD2C or CORD2S in front of those that refer to "
              "it (the axes of grids may also be a CORD1R, CORD1C or CORD1S).");
  }
  return found->second;
}

void DeckBuilder::claim(const CardReader& card, int id) {
  if (!element_ids.insert(id).second) {
    card.fail("an element of this id exists already",
              "Renumber one of the two.");
  }
}

void DeckBuilder::warn(const CardReader& card, const std::string& text) {
  deck.warnings.push_back(fmt::format("{}: {}", card.where(), text));
}

CardTable grid_cards() { return {{"GRID", read_grid}}; }
CardTable grid_axes_cards() { return {{"GRID", read_axes}}; }

}  // namespace tapfit::structure
