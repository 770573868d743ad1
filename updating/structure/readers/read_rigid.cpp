// RBE1, RBE2, RBAR, RROD. One grid leads RBE2 and most RBAR; where six
// components of several grids lead (RBE1, some RBAR), those that follow are
// relations,
//
//   u_m = S_m S_n^-1 u_n,
//
// S the rigid motion's shares in them, n the six.
// Source: MSC Nastran Quick Reference Guide, entries of these names; MSC
// Nastran Linear Static Analysis User's Guide, "R-type elements".
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/dof_relations.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::structure {
namespace {

const char* const all = "123456";

void add_dependent(DeckBuilder& builder,
                   const CardReader& card,
                   const Dependent& dependent,
                   RigidElement& e) {
  static_cast<void>(builder.grid(card, dependent.grid));
  const bool named = std::any_of(
      e.dependents.begin(), e.dependents.end(), [&](const Dependent& d) {
        return d.grid == dependent.grid;
      });
  if (named || dependent.grid == e.independent) {
    card.fail("the element names a grid twice", "Correct the grids.");
  }
  e.dependents.push_back(dependent);
}

// The grids of a list with THRU, each once; those of THRU that exist.
std::vector<int> listed_grids(const DeckBuilder& builder,
                              const CardReader& card,
                              std::size_t first,
                              std::size_t end) {
  std::vector<int> grids;
  for (std::size_t at = first; at < end; ++at) {
    if (card.blank(at)) continue;
    if (upper(card.text(at)) != "THRU") {
      grids.push_back(card.id(at, "GM"));
      continue;
    }
    const auto [from, to] = card.range(at++, "GM");
    for (const Grid& grid : builder.deck.grids) {
      if (grid.id > from && grid.id <= to) grids.push_back(grid.id);
    }
  }
  return grids;
}

// A real at the end is the thermal expansion, which nothing here asks for.
std::size_t end_of_grids(const CardReader& card) {
  std::size_t end = card.size();
  if (end > 4 && card.text(end - 1).find('.') != std::string::npos) --end;
  return end;
}

void read_rbe2(DeckBuilder& builder, const CardReader& card) {
  auto e = claimed_by<RigidElement>(builder, card);
  e.independent = builder.grid(card, card.id(2, "GN")).id;
  const std::string components = card.components(3);
  if (components.empty()) {
    card.fail("field 4 (CM) names no component",
              "Give the components that follow, 123456 for a rigid body.");
  }
  for (const int grid : listed_grids(builder, card, 4, end_of_grids(card))) {
    add_dependent(builder, card, {grid, components}, e);
  }
  if (e.dependents.empty()) {
    card.fail("the element has no dependent grid", "Name one in field 5 (GM).");
  }
  builder.deck.rigids.push_back(e);
}

// Six independent components and those that follow, on one rigid body.
void add_rigid(DeckBuilder& builder,
               const CardReader& card,
               const std::vector<RelationDof>& lead,
               const std::vector<RelationDof>& follow) {
  if (lead.size() != 6) {
    card.fail(fmt::format("{} components lead, six are needed", lead.size()),
              "Give six independent components in all.");
  }
  const Eigen::Vector3d about = builder.grid(card, lead.front().grid).position;
  double size = 0.0;
  for (const auto& dofs : {lead, follow}) {
    for (const RelationDof& dof : dofs) {
      size = std::max(size,
                      (builder.grid(card, dof.grid).position - about).norm());
    }
  }
  if (size == 0.0) size = 1.0;
  const auto share = [&](const RelationDof& dof) {
    Row6 row = rigid_share(builder.grid(card, dof.grid), dof.component, about);
    row.tail<3>() /= size;
    return Row6(dof.component > 3 ? row * size : row);
  };
  Matrix6 S;
  for (std::size_t k = 0; k < 6; ++k) {
    S.row(static_cast<Eigen::Index>(k)) = share(lead[k]);
  }
  Eigen::FullPivLU<Matrix6> lu(S);
  lu.setThreshold(1e-9);
  if (!lu.isInvertible()) {
    card.fail("its independent components do not hold a rigid body",
              "Choose six that leave it no motion.");
  }
  const Matrix6 inverse = lu.inverse();
  for (const RelationDof& dof : follow) {
    Row6 factors = share(dof) * inverse;
    // Back from lengths for turns.
    if (dof.component > 3) factors /= size;
    for (std::size_t k = 0; k < 6; ++k) {
      if (lead[k].component > 3) factors(static_cast<Eigen::Index>(k)) *= size;
    }
    add_relation(builder, card, dof, lead, factors.transpose());
  }
}

void read_shared_rbar(DeckBuilder& builder, const CardReader& card) {
  std::vector<RelationDof> lead;
  std::vector<RelationDof> follow;
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    const int grid = existing_grid(builder, card, 2 + end);
    const std::string own = card.components(4 + end);
    std::string dependent = card.components(6 + end);
    if (card.blank(6) && card.blank(7)) {
      for (const char digit : std::string("123456")) {
        if (own.find(digit) == std::string::npos) dependent += digit;
      }
    }
    add_components(builder, card, grid, own, 1.0, lead);
    add_components(builder, card, grid, dependent, 1.0, follow);
  }
  add_rigid(builder, card, lead, follow);
}

bool leads(std::string components) {
  std::sort(components.begin(), components.end());
  return components == all;
}

void read_rbar(DeckBuilder& builder, const CardReader& card) {
  auto e = claimed_by<RigidElement>(builder, card);
  const std::string lead_a = card.components(4);
  const std::string lead_b = card.components(5);
  const bool from_a = leads(lead_a) && lead_b.empty();
  if (!from_a && !(leads(lead_b) && lead_a.empty())) {
    read_shared_rbar(builder, card);
    return;
  }
  e.independent = builder.grid(card, card.id(from_a ? 2 : 3, "G")).id;
  std::string follow = card.components(from_a ? 7 : 6);
  if (follow.empty()) follow = all;
  add_dependent(builder, card, {card.id(from_a ? 3 : 2, "G"), follow}, e);
  builder.deck.rigids.push_back(e);
}

}  // namespace

void read_rbe1(DeckBuilder& builder, const CardReader& card) {
  builder.claim(card, card.id(1, "EID"));
  std::vector<std::size_t> lead;
  std::vector<std::size_t> follow;
  bool behind = false;
  for (const std::size_t at : filled_fields(card, 2)) {
    if (upper(card.text(at)) == "UM") {
      behind = true;
    } else if (card.text(at).find('.') == std::string::npos) {
      (behind ? follow : lead).push_back(at);
    }
  }
  add_rigid(builder,
            card,
            read_pairs(builder, card, lead),
            read_pairs(builder, card, follow));
}

// Along the line between its grids both move alike.
void read_rrod(DeckBuilder& builder, const CardReader& card) {
  builder.claim(card, card.id(1, "EID"));
  const Grid& a = builder.grid(card, card.id(2, "GA"));
  const Grid& b = builder.grid(card, card.id(3, "GB"));
  const Eigen::Vector3d along = b.position - a.position;
  if (!(along.norm() > 0.0)) {
    card.fail("the rod has no length", "Give two grids at different places.");
  }
  const bool of_a = !card.blank(4);
  const Grid& own = of_a ? a : b;
  const Grid& other = of_a ? b : a;
  const Eigen::Vector3d d = own.axes.transpose() * along.normalized();
  const Eigen::Vector3d e = other.axes.transpose() * along.normalized();
  const int c = card.integer(of_a ? 4 : 5, "CM");
  if (c < 1 || c > 3 || std::abs(d(c - 1)) < 1e-6) {
    card.fail("its dependent component does not lie along the rod",
              "Choose one of 1 to 3 that moves along it.");
  }
  std::vector<RelationDof> on;
  Eigen::VectorXd factors(5);
  Eigen::Index count = 0;
  for (int k = 1; k <= 3; ++k) {
    on.push_back({other.id, k});
    factors(count++) = e(k - 1) / d(c - 1);
    if (k == c) continue;
    on.push_back({own.id, k});
    factors(count++) = -d(k - 1) / d(c - 1);
  }
  add_relation(builder, card, {own.id, c}, on, factors);
}

CardTable rigid_cards() { return {{"RBE2", read_rbe2}, {"RBAR", read_rbar}}; }

}  // namespace tapfit::structure
