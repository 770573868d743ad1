// Coordinate systems and grids, whichever refers to which: a system by points
// (CORD2R) to another system, a grid (CP) to a system, a system by grids
// (CORD1R) to grids. Read in rounds, each time what refers to known ones.
#include "updating/structure/readers/deck_builder.hpp"

#include <algorithm>

namespace tapfit::structure {
namespace {

bool known_system(const DeckBuilder& builder,
                  const CardReader& card,
                  std::size_t field) {
  const int id = card.integer_or(field, 0, "system");
  return id == 0 || builder.deck.systems.contains(id);
}

bool known_grids(const DeckBuilder& builder,
                 const CardReader& card,
                 std::size_t first) {
  if (first > 1 && card.blank(first)) return true;
  for (std::size_t k = 1; k <= 3; ++k) {
    const int id = card.integer_or(first + k, 0, "G");
    if (!builder.grid_index.contains(id)) return false;
  }
  return true;
}

bool is_ready(const DeckBuilder& builder, const CardReader& card) {
  const std::string& name = card.card().name();
  if (name == "GRID") return known_system(builder, card, 2);
  if (name.starts_with("CORD2")) return known_system(builder, card, 2);
  return known_grids(builder, card, 1) && known_grids(builder, card, 5);
}

// Grids in the order of their cards.
void restore_order(DeckBuilder& builder, const std::vector<Card>& cards) {
  std::vector<Grid> ordered;
  for (const Card& card : cards) {
    if (card.name() != "GRID") continue;
    const int id = CardReader(card).id(1, "ID");
    ordered.push_back(builder.deck.grids[builder.grid_index.at(id)]);
  }
  for (std::size_t k = 0; k < ordered.size(); ++k) {
    builder.grid_index[ordered[k].id] = k;
  }
  builder.deck.grids = std::move(ordered);
}

}  // namespace

void read_places(DeckBuilder& builder, const std::vector<Card>& cards) {
  CardTable tables = coordinate_cards();
  tables.merge(grid_cards());
  tables.merge(grid_coordinate_cards());
  std::vector<const Card*> waiting;
  for (const Card& card : cards) {
    if (tables.contains(card.name())) waiting.push_back(&card);
  }
  bool late = false;
  while (!waiting.empty()) {
    std::vector<const Card*> left;
    for (const Card* card : waiting) {
      if (is_ready(builder, CardReader(*card))) {
        tables.at(card->name())(builder, CardReader(*card));
      } else {
        left.push_back(card);
      }
    }
    if (left.size() == waiting.size()) {
      // It says what it refers to in vain.
      tables.at(left.front()->name())(builder, CardReader(*left.front()));
      left.erase(left.begin());
    }
    late = late || !left.empty();
    waiting = std::move(left);
  }
  if (late) restore_order(builder, cards);
}

}  // namespace tapfit::structure
