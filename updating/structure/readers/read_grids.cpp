// GRID, SPOINT.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

namespace tapfit::structure {
namespace {

// Farther out, lengths and their cubes are no numbers to reckon with.
Eigen::Vector3d position_of(const CardReader& card,
                            const CoordinateSystem& system) {
  constexpr double farthest = 1e9;
  const Eigen::Vector3d written = card.vector(3, "position");
  if (!(written.cwiseAbs().maxCoeff() <= farthest)) {
    card.fail(fmt::format("the coordinate {:g} is farther away than {:g}",
                          written.cwiseAbs().maxCoeff(),
                          farthest),
              "Correct the coordinate, also its exponent: 1.+2 means 100.");
  }
  return system.place(written);
}

void read_grid(DeckBuilder& builder, const CardReader& card) {
  const int id = card.id(1, "ID");
  const CoordinateSystem& system =
      builder.system(card, card.integer_or(2, 0, "CP"));
  Grid grid;
  grid.id = id;
  grid.position = position_of(card, system);
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

// One degree of freedom each; THRU makes those between.
void read_spoint(DeckBuilder& builder, const CardReader& card) {
  const auto add = [&](int id) {
    Grid grid;
    grid.id = id;
    grid.position.setZero();
    grid.scalar = true;
    const auto [known, fresh] =
        builder.grid_index.emplace(id, builder.deck.grids.size());
    if (!fresh) {
      // A point may be named more than once.
      if (builder.deck.grids[known->second].scalar) return;
      card.fail(fmt::format("a grid {} exists already", id),
                "Renumber one of the two.");
    }
    builder.deck.grids.push_back(grid);
    builder.permanent.push_back({id, "23456"});
  };
  constexpr int most = 1000000;
  for (std::size_t at = 1; at < card.size(); ++at) {
    if (card.blank(at)) continue;
    if (upper(card.text(at + 1)) != "THRU") {
      add(card.id(at, "ID"));
      continue;
    }
    const auto [from, to] = card.range(at + 1, "ID");
    if (to - from > most) {
      card.fail(fmt::format("{} THRU {} makes too many points", from, to),
                "Correct the ids.");
    }
    for (int id = from; id <= to; ++id) add(id);
    at += 2;
  }
}

}  // namespace

void place_scalar_points(DeckBuilder& builder) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (const Grid& grid : builder.deck.grids) {
    if (grid.scalar) continue;
    middle += grid.position;
    count += 1.0;
  }
  if (count > 0.0) middle /= count;
  for (Grid& grid : builder.deck.grids) {
    if (grid.scalar) grid.position = middle;
  }
}

int existing_grid(const DeckBuilder& builder,
                  const CardReader& card,
                  std::size_t field) {
  const int id = card.id(field, "grid");
  return builder.grid(card, id).id;
}

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
  static const CoordinateSystem basic_system;
  if (id == 0) return basic_system;
  const auto found = deck.systems.find(id);
  if (found == deck.systems.end()) {
    card.fail(fmt::format("coordinate system {} does not exist", id),
              "Add a CORD2R, CORD2C, CORD2S or a CORD1R, CORD1C, CORD1S whose "
              "grids do not lie in it.");
  }
  return found->second;
}

void DeckBuilder::define(const CardReader& card,
                         const std::string& kind,
                         int id) {
  const auto [first, fresh] = defined.try_emplace({kind, id}, card.where());
  if (fresh) return;
  card.fail(
      fmt::format("{} {} is defined already by {}", kind, id, first->second),
      "Keep the one that is meant, or renumber one of the two.");
}

void DeckBuilder::claim(const CardReader& card, int id) {
  if (!element_ids.insert(id).second) {
    card.fail("an element of this id exists already",
              "Renumber one of the two.");
  }
}

void DeckBuilder::warn(const CardReader& card, const std::string& text) {
  const auto [place, fresh] =
      warned_.try_emplace({card.card().name(), text}, warnings_.size());
  if (fresh) warnings_.push_back({card.where(), text});
  ++warnings_[place->second].count;
}

void DeckBuilder::hand_over_warnings() {
  for (const Warning& warning : warnings_) {
    const std::string more =
        warning.count > 1 ? fmt::format(" and {} more", warning.count - 1) : "";
    deck.warnings.push_back(
        fmt::format("{}{}: {}", warning.where, more, warning.text));
  }
  warnings_.clear();
  warned_.clear();
}

CardTable grid_cards() { return {{"GRID", read_grid}}; }
CardTable scalar_point_cards() { return {{"SPOINT", read_spoint}}; }
CardTable grid_axes_cards() { return {{"GRID", read_axes}}; }

}  // namespace tapfit::structure
