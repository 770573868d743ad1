// SPC, SPC1, SPCADD and the permanent constraints of GRID.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

// A scalar point's only component is written as 0 or 1.
Constraint held_at(const Grid& grid, const std::string& components) {
  return {grid.id, grid.scalar ? "1" : components};
}

void read_spc(DeckBuilder& builder, const CardReader& card) {
  const int set = card.id(1, "SID");
  for (std::size_t at : {std::size_t{2}, std::size_t{5}}) {
    if (card.blank(at)) continue;
    const Grid& grid = builder.grid(card, card.id(at, "G"));
    if (card.real_or(at + 2, 0.0, "D") != 0.0) {
      builder.warn(card, "an enforced displacement is taken as zero");
    }
    builder.constraint_sets[set].push_back(
        held_at(grid, card.components(at + 1)));
  }
}

void read_spc1(DeckBuilder& builder, const CardReader& card) {
  std::vector<Constraint>& held = builder.constraint_sets[card.id(1, "SID")];
  const std::string components = card.components(2);
  const std::size_t before = held.size();
  for (std::size_t at = 3; at < card.size(); ++at) {
    if (card.blank(at)) continue;
    if (upper(card.text(at)) != "THRU") {
      held.push_back(held_at(builder.grid(card, card.id(at, "G")), components));
      continue;
    }
    const auto [from, to] = card.range(at, "G");
    // THRU may run over ids that do not exist.
    for (const Grid& grid : builder.deck.grids) {
      if (grid.id > from && grid.id <= to) {
        held.push_back(held_at(grid, components));
      }
    }
    ++at;
  }
  if (held.size() == before) {
    builder.warn(card,
                 "it holds nothing: no grid is named from field 4 on, or none "
                 "exists");
  } else if (std::all_of(
                 held.begin() + static_cast<std::ptrdiff_t>(before),
                 held.end(),
                 [](const Constraint& c) { return c.components.empty(); })) {
    builder.warn(card, "it holds nothing: field 3 names no component");
  }
}

void read_spcadd(DeckBuilder& builder, const CardReader& card) {
  std::vector<int>& sets = builder.added_sets[card.id(1, "SID")];
  for (std::size_t at = 2; at < card.size(); ++at) {
    if (!card.blank(at)) sets.push_back(card.id(at, "S"));
  }
}

std::vector<int> chosen_sets(const DeckBuilder& builder,
                             std::optional<int> chosen) {
  std::vector<int> sets;
  if (!chosen) {
    for (const auto& [id, held] : builder.constraint_sets) sets.push_back(id);
    return sets;
  }
  const auto added = builder.added_sets.find(*chosen);
  if (added != builder.added_sets.end()) sets = added->second;
  if (builder.constraint_sets.contains(*chosen)) sets.push_back(*chosen);
  return sets;
}

}  // namespace

CardTable constraint_cards() {
  return {{"SPC", read_spc}, {"SPC1", read_spc1}, {"SPCADD", read_spcadd}};
}

void apply_constraints(DeckBuilder& builder, std::optional<int> chosen) {
  const std::vector<int> sets = chosen_sets(builder, chosen);
  if (chosen && sets.empty()) {
    builder.deck.warnings.push_back(fmt::format(
        "the case control selects SPC {}, which does not exist: only the "
        "grids' own constraints hold the model",
        *chosen));
  }
  std::vector<Constraint>& all = builder.deck.constraints;
  all = builder.permanent;
  for (const int set : sets) {
    const auto found = builder.constraint_sets.find(set);
    if (found == builder.constraint_sets.end()) continue;
    all.insert(all.end(), found->second.begin(), found->second.end());
  }
}

}  // namespace tapfit::structure
