// RBE3: a grid that moves as the weighted mean of others.
//
// With S_k the rigid motion's share in component k of a grid at r from the
// reference grid, w_k its weight,
//
//   u_ref = X^-1 sum_k w_k S_k' u_k,   X = sum_k w_k S_k' S_k
//
// Source: MSC Nastran Quick Reference Guide, entry RBE3; MSC Nastran Linear
// Static Analysis User's Guide, "R-type elements" (weights of rotations count
// with the square of the mean arm).
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/dof_relations.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

struct Rbe3 {
  int reference = 0;
  std::string components;
  std::vector<RelationDof> on;
  std::vector<RelationDof> um;  // what depends instead of the reference
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
  const std::vector<std::size_t> fields = filled_fields(card, 5);
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
  for (const RelationDof& dof : e.on) {
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
    const RelationDof& dof = e.on[static_cast<std::size_t>(k)];
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

// u_ref - A u = 0, solved for those of UM.
// @param own A, of the components that follow
void add_solved_for_um(DeckBuilder& builder,
                       const CardReader& card,
                       const Rbe3& e,
                       const std::vector<RelationDof>& reference,
                       const Eigen::MatrixXd& own) {
  const Eigen::Index rows = own.rows();
  std::vector<RelationDof> all = reference;
  all.insert(all.end(), e.on.begin(), e.on.end());
  Eigen::MatrixXd equations(rows, rows + own.cols());
  equations << Eigen::MatrixXd::Identity(rows, rows), -own;
  std::vector<Eigen::Index> follow;
  std::vector<Eigen::Index> lead;
  std::vector<RelationDof> leaders;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool in_um = std::ranges::any_of(e.um, [&](const RelationDof& dof) {
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

}  // namespace

void read_rbe3(DeckBuilder& builder, const CardReader& card) {
  builder.claim(card, card.id(1, "EID"));
  const Rbe3 e = rbe3_fields(builder, card);
  if (e.on.empty()) {
    card.fail("the element averages no grid",
              "Give weight, components and grids from field 6 on.");
  }
  const double arm = mean_arm(builder, card, e);
  const Eigen::MatrixXd A = average(builder, card, e);
  const auto rows = static_cast<Eigen::Index>(e.components.size());
  Eigen::MatrixXd own(rows, A.cols());
  std::vector<RelationDof> reference;
  for (Eigen::Index r = 0; r < rows; ++r) {
    const int c = e.components[static_cast<std::size_t>(r)] - '0';
    own.row(r) = A.row(c - 1) / (c > 3 ? arm : 1.0);
    reference.push_back({e.reference, c});
  }
  if (!e.um.empty()) {
    add_solved_for_um(builder, card, e, reference, own);
    return;
  }
  for (Eigen::Index r = 0; r < rows; ++r) {
    add_relation(builder,
                 card,
                 reference[static_cast<std::size_t>(r)],
                 e.on,
                 own.row(r).transpose());
  }
}

}  // namespace tapfit::structure
