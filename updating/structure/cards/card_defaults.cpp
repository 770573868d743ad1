#include "updating/structure/cards/card_defaults.hpp"

#include "updating/structure/cards/card_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

namespace tapfit::structure {
namespace {

using Groups = std::vector<std::vector<std::size_t>>;  // filled together

struct Defaults {
  std::string of;  // the cards that take them
  Groups groups;
};

const std::map<std::string, Defaults>& kinds() {
  const Groups bar{{2}, {5, 6, 7}, {8}};
  static const std::map<std::string, Defaults> known_kinds{
      {"GRDSET", {"GRID", {{2}, {6}, {7}}}},
      {"BAROR", {"CBAR", bar}},
      {"BEAMOR", {"CBEAM", bar}}};
  return known_kinds;
}

void fill(const Card& from, const Groups& groups, Card& card) {
  constexpr std::size_t fields_per_line = 9;
  card.fields.resize(std::max(card.fields.size(), fields_per_line));
  for (const std::vector<std::size_t>& group : groups) {
    const bool blank =
        std::all_of(group.begin(), group.end(), [&](std::size_t field) {
          return card.fields[field].empty();
        });
    if (!blank) continue;
    for (const std::size_t field : group) {
      card.fields[field] = CardReader(from).text(field);
    }
  }
}

}  // namespace

bool is_default_card(const std::string& name) { return kinds().contains(name); }

void fill_defaults(BulkData& bulk) {
  std::map<std::string, Card> given;  // by the cards that take them
  for (const Card& card : bulk.cards) {
    const auto kind = kinds().find(card.name());
    if (kind == kinds().end()) continue;
    const auto [first, fresh] = given.try_emplace(kind->second.of, card);
    if (fresh) continue;
    CardReader(card).fail(
        fmt::format("{} gives these defaults already", first->second.where),
        "Keep one of the two.");
  }
  if (given.empty()) return;
  for (Card& card : bulk.cards) {
    const auto defaults = given.find(card.name());
    if (defaults == given.end()) continue;
    fill(defaults->second, kinds().at(defaults->second.name()).groups, card);
  }
}

}  // namespace tapfit::structure
