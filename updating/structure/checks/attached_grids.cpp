#include "updating/structure/checks/attached_grids.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/card_reader.hpp"
#include "updating/structure/cards/listed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {
namespace {

// The grid that orients a bar need not be part of the model.
std::optional<int> orienting_grid(const Card& card) {
  const std::string& name = card.name();
  if (name != "CBAR" && name != "CBEAM" && name != "CBUSH") return {};
  return parse_integer(CardReader(card).text(5));
}

// Grids of a card that is nothing but mass.
std::vector<int> mass_grids(const Card& card) {
  std::vector<std::size_t> fields;
  const std::string& name = card.name();
  if (name == "CONM1" || name == "CONM2") fields = {2};
  if (name == "CMASS1" || name == "CMASS2") fields = {3, 5};
  if (name == "CMASS3" || name == "CMASS4") fields = {3, 4};
  std::vector<int> grids;
  for (const std::size_t field : fields) {
    const int grid = CardReader(card).integer_or(field, 0, "grid");
    if (grid != 0) grids.push_back(grid);
  }
  return grids;
}

// Masses none of whose grids is attached; their grids count as named.
void warn_loose_masses(const BulkData& bulk,
                       std::set<int>& attached,
                       Deck& deck) {
  std::vector<std::string> cards;
  std::set<int> named;
  for (const Card& card : bulk.cards) {
    const std::vector<int> grids = mass_grids(card);
    const bool loose = !grids.empty() &&
                       std::none_of(grids.begin(), grids.end(), [&](int grid) {
                         return attached.contains(grid);
                       });
    if (!loose) continue;
    cards.push_back(
        fmt::format("{} on GRID {}", CardReader(card).where(), grids.front()));
    named.insert(grids.begin(), grids.end());
  }
  if (cards.empty()) return;
  deck.warnings.push_back(fmt::format(
      "{}: no element with stiffness is attached to the grid, so the mass "
      "counts in the total but moves in no mode; join the grid to the model "
      "(RBE2, CBUSH, a bar) or remove the mass",
      listed(cards)));
  attached.merge(named);
}

}  // namespace

std::set<int> attached_grids(const Deck& deck) {
  std::set<int> grids;
  const auto take = [&grids](const auto& elements) {
    for (const auto& e : elements) {
      grids.insert(e.grids.begin(), e.grids.end());
    }
  };
  for (const Shell& e : deck.shells) {
    const std::vector<int> own = e.all_grids();
    grids.insert(own.begin(), own.end());
  }
  for (const Solid& e : deck.solids) {
    const std::vector<int> own = e.all_grids();
    grids.insert(own.begin(), own.end());
  }
  for (const Relation& e : deck.relations) {
    grids.insert(e.grid);
    for (const RelationTerm& term : e.terms) grids.insert(term.grid);
  }
  for (const MatrixTerm& term : deck.stiffness_terms) {
    grids.insert(term.grids.begin(), term.grids.end());
  }
  take(deck.bars);
  take(deck.rods);
  take(deck.bushes);
  for (const ScalarElement& e : deck.scalars) {
    if (e.stiffness != 0.0) grids.insert(e.grids.begin(), e.grids.end());
  }
  for (const RigidElement& e : deck.rigids) {
    grids.insert(e.independent);
    for (const Dependent& d : e.dependents) grids.insert(d.grid);
  }
  return grids;
}

void warn_unattached(const BulkData& bulk, Deck& deck) {
  std::set<int> attached = attached_grids(deck);
  warn_loose_masses(bulk, attached, deck);
  for (const Card& card : bulk.cards) {
    const std::optional<int> grid = orienting_grid(card);
    if (grid) attached.insert(*grid);
  }
  for (const std::array<int, 2>& ends : deck.plot_lines) {
    attached.insert(ends.begin(), ends.end());
  }
  int first = 0;
  int line = 0;
  int count = 0;
  for (const Card& card : bulk.cards) {
    if (card.name() != "GRID") continue;
    const int id = CardReader(card).id(1, "ID");
    if (attached.contains(id)) continue;
    if (count++ == 0) {
      first = id;
      line = card.line;
    }
  }
  if (count == 0) return;
  deck.warnings.push_back(fmt::format(
      "GRID {} (line {}, {} in all) is attached to no element: it is left out "
      "of the modes; attach or remove it",
      first,
      line,
      count));
}

}  // namespace tapfit::structure
