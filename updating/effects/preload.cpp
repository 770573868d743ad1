#include "updating/effects/preload.hpp"

#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/geometric_stiffness.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace tapfit::effects {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using structure::Deck;
using structure::SparseMatrix;
using Triplets = std::vector<Eigen::Triplet<double>>;

Index first_dof(const Deck& deck, int grid) {
  return 6 * static_cast<Index>(deck.grid_index(grid));
}

// Forces carried, by element.
struct Carried {
  std::map<int, double> lines;     // of bars and rods, tension [N]
  std::map<int, Matrix3d> sheets;  // of shells, basic axes [N/m]
};

double grid_distance(const Deck& deck, const std::array<int, 2>& grids) {
  return (deck.grids[deck.grid_index(grids[1])].position -
          deck.grids[deck.grid_index(grids[0])].position)
      .norm();
}

// What a member that is made too short would carry if nothing gave: a unit in
// bars and rods, a unit of strain in shells.
Carried initial_forces(const Deck& deck,
                       const std::set<int>& own,
                       const Vector3d& axis) {
  Carried carried;
  for (const auto& bar : deck.bars) {
    if (own.contains(bar.id)) carried.lines[bar.id] = 1.0;
  }
  for (const auto& rod : deck.rods) {
    if (own.contains(rod.id)) carried.lines[rod.id] = 1.0;
  }
  for (const auto& shell : deck.shells) {
    if (!own.contains(shell.id)) continue;
    const structure::ShellPlane plane = structure::shell_plane(deck, shell);
    const Vector3d normal = plane.axes.col(2);
    const Vector3d a = (axis - normal * normal.dot(axis)).normalized();
    const double stiff = 0.5 * (plane.membrane(0, 0) + plane.membrane(1, 1));
    carried.sheets[shell.id] = stiff * a * a.transpose();
  }
  return carried;
}

// By which elements pull at their grids.
VectorXd pull_of(const Deck& deck, const Carried& carried) {
  VectorXd f = VectorXd::Zero(6 * std::ssize(deck.grids));
  for (const auto& bar : deck.bars) {
    const auto own = carried.lines.find(bar.id);
    if (own == carried.lines.end()) continue;
    const Vector3d pull = own->second * structure::bar_axis(deck, bar);
    for (const std::size_t end : {0U, 1U}) {
      const Vector3d inward = end == 0 ? pull : Vector3d(-pull);
      const Index at = first_dof(deck, bar.grids.at(end));
      f.segment<3>(at) += inward;
      f.segment<3>(at + 3) += bar.offsets.at(end).cross(inward);
    }
  }
  for (const auto& rod : deck.rods) {
    const auto own = carried.lines.find(rod.id);
    if (own == carried.lines.end()) continue;
    const Vector3d pull = own->second * structure::rod_axis(deck, rod);
    f.segment<3>(first_dof(deck, rod.grids[0])) += pull;
    f.segment<3>(first_dof(deck, rod.grids[1])) -= pull;
  }
  for (const auto& shell : deck.shells) {
    const auto own = carried.sheets.find(shell.id);
    if (own == carried.sheets.end()) continue;
    const structure::ShellPlane plane = structure::shell_plane(deck, shell);
    for (std::size_t i = 0; i < shell.grids.size(); ++i) {
      f.segment<3>(first_dof(deck, shell.grids[i])) -=
          plane.area * own->second *
          plane.slopes.row(static_cast<Index>(i)).transpose();
    }
  }
  return f;
}

// Displacements at rest.
VectorXd at_rest(const structure::System& system, const VectorXd& f) {
  // Far below any mode, and enough to keep what nothing holds where it is.
  constexpr double slight = 1e-12;
  const structure::FreeMotions motions = structure::free_motions(system);
  const SparseMatrix K = motions.reduce(system.K);
  const SparseMatrix M = motions.reduce(system.M);
  const double mass = std::max(M.diagonal().sum(), 1e-300);
  const double shift = slight * K.diagonal().sum() / mass;
  const structure::Factor factor(K + shift * M);
  return motions.expand(factor.solve(motions.project(f)));
}

double tension_in(const structure::ElementMatrices& e,
                  const Deck& deck,
                  const VectorXd& u,
                  const Vector3d& axis) {
  VectorXd own(12);
  own << u.segment<6>(first_dof(deck, e.grids[0])),
      u.segment<6>(first_dof(deck, e.grids[1]));
  return axis.dot((e.K.middleRows(6, 3) * own).eval());
}

// What displacements add to the forces.
void add_answer(const Deck& deck, const VectorXd& u, Carried& carried) {
  for (const auto& bar : deck.bars) {
    carried.lines[bar.id] += tension_in(structure::bar_matrices(deck, bar),
                                        deck,
                                        u,
                                        structure::bar_axis(deck, bar));
  }
  for (const auto& rod : deck.rods) {
    carried.lines[rod.id] += tension_in(structure::rod_matrices(deck, rod),
                                        deck,
                                        u,
                                        structure::rod_axis(deck, rod));
  }
  for (const auto& shell : deck.shells) {
    const auto n = static_cast<Index>(shell.grids.size());
    Eigen::MatrixX3d own(n, 3);
    for (Index i = 0; i < n; ++i) {
      const int grid = shell.grids[static_cast<std::size_t>(i)];
      own.row(i) = u.segment<3>(first_dof(deck, grid)).transpose();
    }
    const Matrix3d N =
        structure::membrane_force(structure::shell_plane(deck, shell), own);
    const auto [it, fresh] = carried.sheets.try_emplace(shell.id, N);
    if (!fresh) it->second += N;
  }
}

// Mean force across the cuts of a member.
double force_across(const Deck& deck,
                    const Carried& carried,
                    const std::set<int>& own,
                    const updating::AxialMember& member) {
  const auto of_line = [&](const auto& e, const Vector3d& axis) {
    const auto it = carried.lines.find(e.id);
    if (!own.contains(e.id) || it == carried.lines.end()) return 0.0;
    return it->second * grid_distance(deck, e.grids) *
           std::pow(axis.dot(member.axis), 2);
  };
  double sum = 0.0;
  for (const auto& bar : deck.bars) {
    sum += of_line(bar, structure::bar_axis(deck, bar));
  }
  for (const auto& rod : deck.rods) {
    sum += of_line(rod, structure::rod_axis(deck, rod));
  }
  for (const auto& shell : deck.shells) {
    const auto it = carried.sheets.find(shell.id);
    if (!own.contains(shell.id) || it == carried.sheets.end()) continue;
    sum += structure::shell_plane(deck, shell).area *
           member.axis.dot(it->second * member.axis);
  }
  return sum / member.length;
}

VectorXd pull_from_outside(const Deck& deck,
                           const updating::AxialMember& member) {
  VectorXd f = VectorXd::Zero(6 * std::ssize(deck.grids));
  const std::vector<int>& grids = member.pulled()->grids;
  for (const int grid : grids) {
    f.segment<3>(first_dof(deck, grid)) +=
        member.outward() / static_cast<double>(grids.size());
  }
  return f;
}

// For a unit force across the member.
Carried carried_by(const Deck& deck,
                   const structure::System& system,
                   const std::set<int>& own,
                   const updating::AxialMember& member) {
  // Of what it would carry by itself: less is what the recovery of forces in
  // shells has left of a structure in which nothing holds the member's length.
  constexpr double nothing = 1e-2;
  const Carried alone = initial_forces(deck, own, member.axis);
  const bool outside = member.pulled() != nullptr;
  Carried carried = outside ? Carried{} : alone;
  add_answer(
      deck,
      at_rest(system,
              outside ? pull_from_outside(deck, member) : pull_of(deck, alone)),
      carried);
  double force = force_across(deck, carried, own, member);
  const double most = outside ? 1.0 : force_across(deck, alone, own, member);
  if (!(std::abs(force) > nothing * std::abs(most))) {
    // Then only something outside can pull at both its ends.
    carried = alone;
    force = force_across(deck, alone, own, member);
  }
  for (auto& [id, N] : carried.lines) N /= force;
  for (auto& [id, N] : carried.sheets) N /= force;
  return carried;
}

void scatter(const Deck& deck,
             const structure::GeometricMatrix& e,
             double factor,
             Triplets& all) {
  const double least = 1e-15 * e.K.diagonal().cwiseAbs().maxCoeff();
  for (Index i = 0; i < e.K.rows(); ++i) {
    for (Index j = 0; j < e.K.cols(); ++j) {
      if (!(std::abs(e.K(i, j)) > least)) continue;
      const auto at = [&](Index k) {
        const int grid = e.grids[static_cast<std::size_t>(k / 6)];
        return static_cast<int>(first_dof(deck, grid) + k % 6);
      };
      all.emplace_back(at(i), at(j), factor * e.K(i, j));
    }
  }
}

// Of the largest force: what carries less does not show.
constexpr double barely = 1e-9;

SparseMatrix geometric_stiffness(const Deck& deck,
                                 const Carried& carried,
                                 double sign) {
  double line = 0.0;
  double sheet = 0.0;
  for (const auto& [id, N] : carried.lines) line = std::max(line, std::abs(N));
  for (const auto& [id, N] : carried.sheets) sheet = std::max(sheet, N.norm());
  Triplets all;
  const auto of_line = [&](const auto& e) {
    const auto it = carried.lines.find(e.id);
    if (it == carried.lines.end()) return;
    if (!(std::abs(it->second) > barely * line)) return;
    scatter(deck, structure::geometric_matrix(deck, e), sign * it->second, all);
  };
  for (const auto& bar : deck.bars) of_line(bar);
  for (const auto& rod : deck.rods) of_line(rod);
  for (const auto& shell : deck.shells) {
    const auto it = carried.sheets.find(shell.id);
    if (it == carried.sheets.end()) continue;
    if (!(it->second.norm() > barely * sheet)) continue;
    scatter(
        deck, structure::geometric_matrix(deck, shell, it->second), sign, all);
  }
  const Index n = 6 * std::ssize(deck.grids);
  SparseMatrix K(n, n);
  K.setFromTriplets(all.begin(), all.end());
  return K;
}

// A unit of stiffness across, shared among the grids that a wire is tied to.
SparseMatrix side_stiffness(const Deck& deck,
                            const updating::AxialMember& member) {
  const Matrix3d off_axis =
      Matrix3d::Identity() - member.axis * member.axis.transpose();
  const std::vector<int>& grids = member.pulled()->grids;
  Triplets all;
  for (const int grid : grids) {
    const auto at = static_cast<int>(first_dof(deck, grid));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        all.emplace_back(
            at + i, at + j, off_axis(i, j) / static_cast<double>(grids.size()));
      }
    }
  }
  const Index n = 6 * std::ssize(deck.grids);
  SparseMatrix K(n, n);
  K.setFromTriplets(all.begin(), all.end());
  return K;
}

}  // namespace

bool is_compression(const updating::Location& where) {
  return where.variant.ends_with("compression");
}

std::optional<updating::AxialMember> member_at(
    const Deck& deck,
    const std::vector<int>& elements,
    const updating::Location& where) {
  return updating::axial_member(
      deck, elements, where.variant.starts_with("across"));
}

Preload preload(const Deck& deck,
                const structure::System& system,
                const std::vector<int>& elements,
                const updating::Location& where) {
  const std::optional<updating::AxialMember> member =
      member_at(deck, elements, where);
  if (!member || !member->can_be_pulled()) {
    const Index n = 6 * std::ssize(deck.grids);
    return {SparseMatrix(n, n)};
  }
  const std::set<int> own(elements.begin(), elements.end());
  Preload result;
  result.along = geometric_stiffness(deck,
                                     carried_by(deck, system, own, *member),
                                     is_compression(where) ? -1.0 : 1.0);
  if (member->pulled() != nullptr) {
    result.side = side_stiffness(deck, *member);
  }
  return result;
}

}  // namespace tapfit::effects
