// GRID, CORD2R.
#include "updating/structure/deck_builder.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tapfit::structure {
namespace {

void read_cord2r(DeckBuilder& builder, const CardReader& card) {
  const int id = card.id(1, "CID");
  const CoordinateSystem reference =
      builder.system(card, card.integer_or(2, 0, "RID"));
  const Eigen::Vector3d a = card.vector(3, "A");
  const Eigen::Vector3d z = card.vector(6, "B") - a;
  const Eigen::Vector3d c = card.vector(9, "C") - a;
  const Eigen::Vector3d y = z.cross(c);
  if (!(y.norm() > 1e-10 * z.norm() * c.norm()) || y.norm() == 0.0) {
    card.fail("the three points of the coordinate system lie on a line",
              "Give a point C that is off the z axis A-B.");
  }
  CoordinateSystem system;
  system.origin = reference.origin + reference.axes * a;
  system.axes.col(2) = reference.axes * z.normalized();
  system.axes.col(1) = reference.axes * y.normalized();
  system.axes.col(0) = system.axes.col(1).cross(system.axes.col(2));
  builder.systems[id] = system;
}

void read_grid(DeckBuilder& builder, const CardReader& card) {
  const int id = card.id(1, "ID");
  const CoordinateSystem& system =
      builder.system(card, card.integer_or(2, 0, "CP"));
  Grid grid;
  grid.id = id;
  grid.position = system.origin + system.axes * card.vector(3, "position");
  if (!builder.grid_index.emplace(id, builder.deck.grids.size()).second) {
    card.fail("a grid of this id exists already", "Renumber one of the two.");
  }
  builder.deck.grids.push_back(grid);
  const int cd = card.integer_or(6, 0, "CD");
  if (cd != 0) {
    static_cast<void>(builder.system(card, cd));
    builder.displacement_system[id] = cd;
  }
  const std::string held = card.components(7);
  if (!held.empty()) builder.permanent.push_back({id, held});
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
              "Add a CORD2R (other kinds are not supported), in front of "
              "those that refer to it.");
  }
  return found->second;
}

const CoordinateSystem& DeckBuilder::displacement(const CardReader& card,
                                                  int id) const {
  const auto found = displacement_system.find(id);
  return system(card, found == displacement_system.end() ? 0 : found->second);
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

CardTable coordinate_cards() { return {{"CORD2R", read_cord2r}}; }
CardTable grid_cards() { return {{"GRID", read_grid}}; }

}  // namespace tapfit::structure
