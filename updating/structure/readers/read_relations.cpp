// MPC, MPCADD, RBE3, RBE1, RROD, and RBAR whose independent components are
// shared between its ends: degrees of freedom that are sums of others.
//
// RBE3: with S_k the rigid motion's share in component k of a grid at r from
// the reference grid, w_k its weight,
//
//   u_ref = X^-1 sum_k w_k S_k' u_k,   X = sum_k w_k S_k' S_k
//
// RBE1, RBAR: u_m = S_m S_n^-1 u_n, n six independent components.
//
// Source: MSC Nastran Quick Reference Guide, entries of these names; MSC
// Nastran Linear Static Analysis User's Guide, "R-type elements" (RBE3:
// weights of rotations count with the square of the mean arm).
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::structure {
namespace {

using Row6 = Eigen::Matrix<double, 1, 6>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// A component of a grid, along its own axes.
struct Dof {
  int grid = 0;
  int component = 0;
  double weight = 1.0;
};

// What a rigid motion about a place moves a component by.
Row6 rigid_share(const Grid& grid,
                 int component,
                 const Eigen::Vector3d& about) {
  const Eigen::Vector3d a = grid.axes.col((component - 1) % 3);
  Row6 share = Row6::Zero();
  if (component > 3) {
    share.tail<3>() = a.transpose();
  } else {
    const Eigen::Vector3d r = grid.position - about;
    share.head<3>() = a.transpose();
    share.tail<3>() = r.cross(a).transpose();
  }
  return share;
}

std::vector<std::size_t> filled(const CardReader& card, std::size_t first) {
  std::vector<std::size_t> fields;
  for (std::size_t at = first; at < card.size(); ++at) {
    if (!card.blank(at)) fields.push_back(at);
  }
  return fields;
}

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

void add_components(const DeckBuilder& builder,
                    const CardReader& card,
                    int grid,
                    const std::string& components,
                    double weight,
                    std::vector<Dof>& dofs) {
  if (builder.grid(card, grid).scalar) {
    card.fail(fmt::format("{} is a scalar point, which has no place", grid),
              "Name a GRID.");
  }
  for (const char digit : components) {
    dofs.push_back({grid, digit - '0', weight});
  }
}

// Pairs of a grid and its components.
std::vector<Dof> read_pairs(const DeckBuilder& builder,
                            const CardReader& card,
                            const std::vector<std::size_t>& fields) {
  std::vector<Dof> dofs;
  for (std::size_t k = 0; k + 1 < fields.size(); k += 2) {
    const int grid = existing_grid(builder, card, fields[k]);
    add_components(
        builder, card, grid, card.components(fields[k + 1]), 1.0, dofs);
  }
  return dofs;
}

// Factors below rounding are none.
void add_relation(DeckBuilder& builder,
                  const CardReader& card,
                  const Dof& dependent,
                  const std::vector<Dof>& on,
                  const Eigen::VectorXd& factors) {
  Relation relation{dependent.grid, dependent.component, {}, card.where()};
  const double most = factors.size() == 0 ? 0.0 : factors.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < on.size(); ++k) {
    const double factor = factors(static_cast<Eigen::Index>(k));
    if (std::abs(factor) <= 1e-13 * most) continue;
    relation.terms.push_back({on[k].grid, on[k].component, factor});
  }
  builder.deck.relations.push_back(std::move(relation));
}

// Six independent components and those that follow, on one rigid body.
void add_rigid(DeckBuilder& builder,
               const CardReader& card,
               const std::vector<Dof>& lead,
               const std::vector<Dof>& follow) {
  if (lead.size() != 6) {
    card.fail(fmt::format("{} components lead, six are needed", lead.size()),
              "Give six independent components in all.");
  }
  const Eigen::Vector3d about = builder.grid(card, lead.front().grid).position;
  double size = 0.0;
  for (const auto& dofs : {lead, follow}) {
    for (const Dof& dof : dofs) {
      size = std::max(size,
                      (builder.grid(card, dof.grid).position - about).norm());
    }
  }
  if (size == 0.0) size = 1.0;
  const auto share = [&](const Dof& dof) {
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
  for (const Dof& dof : follow) {
    Row6 factors = share(dof) * inverse;
    // Back from lengths for turns.
    if (dof.component > 3) factors /= size;
    for (std::size_t k = 0; k < 6; ++k) {
      if (lead[k].component > 3) factors(static_cast<Eigen::Index>(k)) *= size;
    }
    add_relation(builder, card, dof, lead, factors.transpose());
  }
}

void take_id(DeckBuilder& builder, const CardReader& card) {
  builder.claim(card, card.id(1, "EID"));
}

void read_rbe1(DeckBuilder& builder, const CardReader& card) {
  take_id(builder, card);
  std::vector<std::size_t> lead;
  std::vector<std::size_t> follow;
  bool behind = false;
  for (const std::size_t at : filled(card, 2)) {
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
  take_id(builder, card);
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
  std::vector<Dof> on;
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

struct Rbe3 {
  int reference = 0;
  std::string components;
  std::vector<Dof> on;
  std::vector<Dof> um;  // what depends instead of the reference
};

Rbe3 rbe3_fields(const DeckBuilder& builder, const CardReader& card) {
  Rbe3 e;
  e.reference = existing_grid(builder, card, 3);
  e.components = card.components(4);
  if (e.components.empty()) {
    card.fail("field 5 (REFC) names no component",
              "Give the components of the reference grid that follow.");
  }
  double weight = 0.0;
  std::string components;
  std::vector<std::size_t> um;
  enum { List, Um, Rest } part = List;
  const std::vector<std::size_t> fields = filled(card, 5);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::size_t at = fields[k];
    const std::string word = upper(card.text(at));
    if (word == "UM") {
      part = Um;
    } else if (word == "ALPHA" || word == "TREF") {
      part = Rest;
    } else if (part == Um) {
      um.push_back(at);
    } else if (part == List && word.find('.') != std::string::npos) {
      weight = card.real(at, "WT");
      if (++k < fields.size()) components = card.components(fields[k]);
    } else if (part == List) {
      const int grid = existing_grid(builder, card, at);
      add_components(builder, card, grid, components, weight, e.on);
    }
  }
  e.um = read_pairs(builder, card, um);
  return e;
}

// Mean arm, by which turns count as lengths; 1 where all are at one place.
double mean_arm(const DeckBuilder& builder,
                const CardReader& card,
                const Rbe3& e) {
  const Eigen::Vector3d at = builder.grid(card, e.reference).position;
  double sum = 0.0;
  for (const Dof& dof : e.on) {
    sum += (builder.grid(card, dof.grid).position - at).norm();
  }
  return sum > 0.0 ? sum / static_cast<double>(e.on.size()) : 1.0;
}

// u_ref = A u, along basic axes. Turns of the reference are in lengths.
// @throws InputError where a component that is asked for is not determined
Eigen::MatrixXd average(const DeckBuilder& builder,
                        const CardReader& card,
                        const Rbe3& e) {
  const Grid& reference = builder.grid(card, e.reference);
  const double arm = mean_arm(builder, card, e);
  const auto n = static_cast<Eigen::Index>(e.on.size());
  Eigen::MatrixXd S(n, 6);
  Eigen::VectorXd w(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Dof& dof = e.on[static_cast<std::size_t>(k)];
    S.row(k) = rigid_share(
        builder.grid(card, dof.grid), dof.component, reference.position);
    S.row(k).tail<3>() /= arm;
    w(k) = dof.weight * (dof.component > 3 ? arm * arm : 1.0);
  }
  const Matrix6 X = S.transpose() * w.asDiagonal() * S;
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(X);
  Matrix6 inverse = Matrix6::Zero();
  Matrix6 known = Matrix6::Zero();  // onto motions that the grids determine
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (!(solver.eigenvalues()(i) > 1e-10 * solver.eigenvalues()(5))) continue;
    const auto v = solver.eigenvectors().col(i);
    inverse += v * v.transpose() / solver.eigenvalues()(i);
    known += v * v.transpose();
  }
  Matrix6 turned = Matrix6::Zero();
  turned.topLeftCorner<3, 3>() = reference.axes.transpose();
  turned.bottomRightCorner<3, 3>() = reference.axes.transpose();
  const Matrix6 lost = turned * (Matrix6::Identity() - known);
  for (const char digit : e.components) {
    if (lost.row(digit - '1').norm() < 1e-6) continue;
    card.fail(fmt::format("its grids do not determine component {} of the "
                          "reference grid {}",
                          digit,
                          e.reference),
              "Name more grids or components, or take it out of REFC.");
  }
  return turned * inverse * S.transpose() * w.asDiagonal();
}

void read_rbe3(DeckBuilder& builder, const CardReader& card) {
  take_id(builder, card);
  const Rbe3 e = rbe3_fields(builder, card);
  if (e.on.empty()) {
    card.fail("the element averages no grid",
              "Give weight, components and grids from field 6 on.");
  }
  const double arm = mean_arm(builder, card, e);
  const Eigen::MatrixXd A = average(builder, card, e);
  const auto rows = static_cast<Eigen::Index>(e.components.size());
  Eigen::MatrixXd own(rows, A.cols());
  std::vector<Dof> reference;
  for (Eigen::Index r = 0; r < rows; ++r) {
    const int c = e.components[static_cast<std::size_t>(r)] - '0';
    own.row(r) = A.row(c - 1) / (c > 3 ? arm : 1.0);
    reference.push_back({e.reference, c});
  }
  if (e.um.empty()) {
    for (Eigen::Index r = 0; r < rows; ++r) {
      add_relation(builder,
                   card,
                   reference[static_cast<std::size_t>(r)],
                   e.on,
                   own.row(r).transpose());
    }
    return;
  }
  // u_ref - A u = 0, solved for those of UM.
  std::vector<Dof> all = reference;
  all.insert(all.end(), e.on.begin(), e.on.end());
  Eigen::MatrixXd equations(rows, rows + own.cols());
  equations << Eigen::MatrixXd::Identity(rows, rows), -own;
  std::vector<Eigen::Index> follow;
  std::vector<Eigen::Index> lead;
  std::vector<Dof> leaders;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool in_um = std::ranges::any_of(e.um, [&](const Dof& dof) {
      return dof.grid == all[k].grid && dof.component == all[k].component;
    });
    (in_um ? follow : lead).push_back(static_cast<Eigen::Index>(k));
    if (!in_um) leaders.push_back(all[k]);
  }
  if (static_cast<Eigen::Index>(follow.size()) != rows ||
      e.um.size() != follow.size()) {
    card.fail(
        fmt::format(
            "UM names {} of its components, REFC {}", follow.size(), rows),
        "Name as many behind UM as in REFC, each one of the element's.");
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(equations(Eigen::all, follow));
  if (!lu.isInvertible()) {
    card.fail("the components behind UM cannot follow from the others",
              "Choose others.");
  }
  const Eigen::MatrixXd factors =
      -lu.solve(Eigen::MatrixXd(equations(Eigen::all, lead)));
  for (std::size_t r = 0; r < follow.size(); ++r) {
    add_relation(builder,
                 card,
                 all[static_cast<std::size_t>(follow[r])],
                 leaders,
                 factors.row(static_cast<Eigen::Index>(r)).transpose());
  }
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

void read_shared_rbar(DeckBuilder& builder, const CardReader& card) {
  std::vector<Dof> lead;
  std::vector<Dof> follow;
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
