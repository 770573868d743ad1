// CORD2R, CORD2C, CORD2S (three points) and CORD1R, CORD1C, CORD1S (three
// grids): z from A to B, the x-z plane holds C.
#include "updating/structure/readers/deck_builder.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::structure {
namespace {

CoordinateKind kind_of(const CardReader& card) {
  switch (card.card().name().back()) {
    case 'C':
      return CoordinateKind::Cylindrical;
    case 'S':
      return CoordinateKind::Spherical;
    default:
      return CoordinateKind::Rectangular;
  }
}

CoordinateSystem system_through(const CardReader& card,
                                const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c) {
  const auto axes = axes_through(2, b - a, c - a);
  if (!axes) {
    card.fail("the three points of the coordinate system lie on a line",
              "Give a point C that is off the z axis A-B.");
  }
  CoordinateSystem system;
  system.kind = kind_of(card);
  system.origin = a;
  system.axes = *axes;
  return system;
}

void read_by_points(DeckBuilder& builder, const CardReader& card) {
  const int id = card.id(1, "CID");
  builder.define(card, "coordinate system", id);
  const CoordinateSystem& reference =
      builder.system(card, card.integer_or(2, 0, "RID"));
  builder.deck.systems[id] =
      system_through(card,
                     reference.place(card.vector(3, "A")),
                     reference.place(card.vector(6, "B")),
                     reference.place(card.vector(9, "C")));
}

// Two systems fit on a card.
void read_by_grids(DeckBuilder& builder, const CardReader& card) {
  for (const std::size_t first : {std::size_t{1}, std::size_t{5}}) {
    if (first > 1 && card.blank(first)) continue;
    const auto at = [&](std::size_t k) {
      return builder.grid(card, card.id(first + k, "G")).position;
    };
    const int id = card.id(first, "CID");
    builder.define(card, "coordinate system", id);
    builder.deck.systems[id] = system_through(card, at(1), at(2), at(3));
  }
}

}  // namespace

CardTable coordinate_cards() {
  return {{"CORD2R", read_by_points},
          {"CORD2C", read_by_points},
          {"CORD2S", read_by_points}};
}

void order_coordinate_cards(std::vector<Card>& cards) {
  const CardTable by_points = coordinate_cards();
  std::vector<std::size_t> places;
  std::map<int, int> reference;
  for (std::size_t k = 0; k < cards.size(); ++k) {
    if (!by_points.contains(cards[k].name())) continue;
    const CardReader card(cards[k]);
    places.push_back(k);
    reference.try_emplace(card.id(1, "CID"), card.integer_or(2, 0, "RID"));
  }
  // How many systems lie between a card's own and the basic one.
  const auto depth = [&reference](const CardReader& card) {
    std::size_t steps = 0;
    auto at = reference.find(card.id(1, "CID"));
    while (at != reference.end()) {
      if (++steps > reference.size()) {
        card.fail("its coordinate system refers to itself round a ring",
                  "Let a system of the ring refer to the basic one (field 3 "
                  "blank).");
      }
      at = reference.find(at->second);
    }
    return steps;
  };
  std::vector<std::pair<std::size_t, Card>> systems;
  for (const std::size_t k : places) {
    systems.emplace_back(depth(CardReader(cards[k])), cards[k]);
  }
  std::ranges::stable_sort(systems, {}, [](const auto& s) { return s.first; });
  for (std::size_t k = 0; k < places.size(); ++k) {
    cards[places[k]] = std::move(systems[k].second);
  }
}

CardTable grid_coordinate_cards() {
  return {{"CORD1R", read_by_grids},
          {"CORD1C", read_by_grids},
          {"CORD1S", read_by_grids}};
}

}  // namespace tapfit::structure
