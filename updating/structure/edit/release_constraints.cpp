#include "updating/structure/edit/release_constraints.hpp"

#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/card_reader.hpp"
#include "updating/structure/edit/hold_cards.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace tapfit::structure {
namespace {

using Cards = std::vector<Card>;
using Released = std::map<int, std::string>;  // grid -> components

constexpr std::size_t permanent = 7;  // of GRID: the field PS

std::string left_of(const std::string& components,
                    int grid,
                    const Released& released) {
  const auto out = released.find(grid);
  if (out == released.end()) return components;
  std::string left;
  for (const char c : components) {
    if (out->second.find(c) == std::string::npos) left += c;
  }
  return left;
}

using HeldGrids = std::vector<std::pair<int, std::string>>;
using Alike = std::map<std::string, std::vector<int>>;  // components -> grids

// What stays held of these; nothing where all does.
std::optional<Alike> left_held(const HeldGrids& held,
                               const Released& released) {
  Alike left;
  bool changed = false;
  for (const auto& [grid, components] : held) {
    const std::string rest = left_of(components, grid, released);
    changed = changed || rest != components;
    if (!rest.empty()) left[rest].push_back(grid);
  }
  if (!changed) return std::nullopt;
  return left;
}

Card list_card(std::vector<std::string> fields, const std::vector<int>& grids) {
  for (const int grid : grids) fields.push_back(std::to_string(grid));
  Card card;
  card.fields = std::move(fields);
  return card;
}

Cards spc1_cards(const std::string& set, const Alike& held) {
  Cards cards;
  for (const auto& [components, grids] : held) {
    cards.push_back(list_card({"SPC1", set, components}, grids));
  }
  return cards;
}

// Cards that hold these grids, each in its components.
std::optional<Cards> held_anew(const std::string& set,
                               const HeldGrids& held,
                               const Released& released) {
  const std::optional<Alike> left = left_held(held, released);
  if (!left) return std::nullopt;
  return spc1_cards(set, *left);
}

std::optional<Cards> spc(const Card& card, const Released& released) {
  const CardReader read(card);
  HeldGrids held;
  for (const std::size_t at : {std::size_t{2}, std::size_t{5}}) {
    if (read.blank(at)) continue;
    held.emplace_back(read.id(at, "G"), read.components(at + 1));
  }
  return held_anew(card.fields.at(1), held, released);
}

std::optional<Cards> spc1(const Card& card,
                          const Deck& deck,
                          const Released& released) {
  const CardReader read(card);
  const std::string components = read.components(2);
  HeldGrids held;
  for (std::size_t at = 3; at < read.size(); ++at) {
    if (read.blank(at)) continue;
    if (upper(read.text(at)) != "THRU") {
      held.emplace_back(read.id(at, "G"), components);
      continue;
    }
    const auto [from, to] = read.range(at, "G");
    for (const Grid& grid : deck.grids) {
      if (grid.id > from && grid.id <= to) {
        held.emplace_back(grid.id, components);
      }
    }
    ++at;
  }
  return held_anew(card.fields.at(1), held, released);
}

std::optional<Cards> grid(const Card& card, const Released& released) {
  const CardReader read(card);
  if (read.blank(permanent)) return std::nullopt;
  const std::string components = read.components(permanent);
  Card changed = card;
  changed.fields[permanent] = left_of(components, read.id(1, "ID"), released);
  std::string& left = changed.fields[permanent];
  if (left == components) return std::nullopt;
  if (left.empty()) left = "0";  // a blank would take GRDSET's
  return Cards{std::move(changed)};
}

// What follows a held grid: one rigid element goes on leading those that are
// alike, an SPC1 holds the others.
std::optional<Cards> rigid(const Card& card,
                           const Deck& deck,
                           const Released& released) {
  const int id = CardReader(card).id(1, "EID");
  const auto e = std::ranges::find(deck.rigids, id, &RigidElement::id);
  if (e == deck.rigids.end()) return std::nullopt;
  HeldGrids held;
  for (const Dependent& d : e->dependents) {
    held.emplace_back(d.grid, d.components);
  }
  std::optional<Alike> left = left_held(held, released);
  if (!left) return std::nullopt;
  if (left->empty()) return Cards{};
  const auto first = left->begin();
  Cards cards = {list_card({"RBE2",
                            std::to_string(id),
                            std::to_string(e->independent),
                            first->first},
                           first->second)};
  left->erase(first);
  for (Card& other : spc1_cards(std::to_string(constraint_set(deck)), *left)) {
    cards.push_back(std::move(other));
  }
  return cards;
}

}  // namespace

CardEdit release_constraints(const Deck& deck,
                             const std::vector<Constraint>& released) {
  Released all;
  for (const Constraint& out : released) all[out.grid] += out.components;
  return [all, &deck](const Card& card) -> std::optional<Cards> {
    if (card.name() == "SPC") return spc(card, all);
    if (card.name() == "SPC1") return spc1(card, deck, all);
    if (card.name() == "GRID") return grid(card, all);
    if (card.name() == "RBE2" || card.name() == "RBAR") {
      return rigid(card, deck, all);
    }
    return std::nullopt;
  };
}

}  // namespace tapfit::structure
