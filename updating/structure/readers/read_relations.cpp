// MPC, MPCADD: degrees of freedom that are sums of others, in sets of which the
// case control chooses one. The table holds rigid elements that become such
// sums too. Source: MSC Nastran Quick Reference Guide, entries of these names.
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::structure {
namespace {

int component_of(const DeckBuilder& builder,
                 const CardReader& card,
                 int grid,
                 std::size_t field) {
  const bool scalar = builder.grid(card, grid).scalar;
  const int component = card.integer_or(field, 0, "component");
  if (scalar && component <= 1) return 1;
  if (component < 1 || component > 6 || scalar) {
    card.fail(
        fmt::format("component {} of grid {} is not there", component, grid),
        "Give one of 1 to 6, of a scalar point 0 or 1.");
  }
  return component;
}

// The first term depends on the others.
void read_mpc(DeckBuilder& builder, const CardReader& card) {
  const int set = card.id(1, "SID");
  Relation relation;
  relation.where = card.where();
  double first = 0.0;
  // Two terms a line; the fields at either end of it are blank.
  for (std::size_t line = 0; line < card.size(); line += 8) {
    for (const std::size_t at : {line + 2, line + 5}) {
      if (card.blank(at)) continue;
      const int grid = existing_grid(builder, card, at);
      const int component = component_of(builder, card, grid, at + 1);
      const double factor = card.real_or(at + 2, 0.0, "A");
      if (first == 0.0) {
        if (factor == 0.0) {
          card.fail("the factor of its first term is zero",
                    "Give A1, or begin with another term.");
        }
        first = factor;
        relation.grid = grid;
        relation.component = component;
      } else if (factor != 0.0) {
        relation.terms.push_back({grid, component, -factor / first});
      }
    }
  }
  if (first == 0.0) {
    card.fail("the equation has no term", "Give grid, component and factor.");
  }
  for (const RelationTerm& term : relation.terms) {
    if (term.grid != relation.grid || term.component != relation.component) {
      continue;
    }
    card.fail(fmt::format("component {} of grid {} is named twice",
                          term.component,
                          term.grid),
              "Add both factors up in one term.");
  }
  builder.relation_sets[set].push_back(std::move(relation));
}

void read_mpcadd(DeckBuilder& builder, const CardReader& card) {
  std::vector<int>& sets = builder.added_relation_sets[card.id(1, "SID")];
  for (std::size_t at = 2; at < card.size(); ++at) {
    if (!card.blank(at)) sets.push_back(card.id(at, "S"));
  }
}

}  // namespace

CardTable relation_cards() {
  return {{"MPC", read_mpc},
          {"MPCADD", read_mpcadd},
          {"RBE1", read_rbe1},
          {"RBE3", read_rbe3},
          {"RROD", read_rrod}};
}

void apply_relations(DeckBuilder& builder, std::optional<int> chosen) {
  std::vector<int> sets;
  if (!chosen) {
    for (const auto& [id, relations] : builder.relation_sets) {
      sets.push_back(id);
    }
  } else {
    const auto added = builder.added_relation_sets.find(*chosen);
    if (added != builder.added_relation_sets.end()) sets = added->second;
    if (builder.relation_sets.contains(*chosen)) sets.push_back(*chosen);
    if (sets.empty()) {
      builder.deck.warnings.push_back(
          fmt::format("the case control selects MPC {}, which does not exist: "
                      "no MPC acts",
                      *chosen));
    }
  }
  std::vector<Relation>& all = builder.deck.relations;
  for (const int set : sets) {
    const auto found = builder.relation_sets.find(set);
    if (found == builder.relation_sets.end()) continue;
    all.insert(all.end(), found->second.begin(), found->second.end());
  }
}

}  // namespace tapfit::structure
