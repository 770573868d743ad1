#include "updating/structure/mesh/free_edge_layer.hpp"

#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/shell_section.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Of an element's twist, for each of its free sides: finer meshes see the
// layer.
constexpr double most_taken = 0.25;

// Sides (from corner k to the next) that no other shell has, by shell.
std::map<const Shell*, std::vector<std::size_t>> free_sides(const Deck& deck) {
  struct Side {
    const Shell* shell = nullptr;
    std::size_t from = 0;
    int shells = 0;
  };
  std::map<std::pair<int, int>, Side> sides;
  for (const Shell& shell : deck.shells) {
    for (std::size_t k = 0; k < shell.grids.size(); ++k) {
      const int a = shell.grids[k];
      const int b = shell.grids[(k + 1) % shell.grids.size()];
      Side& side = sides[std::minmax(a, b)];
      side = {&shell, k, side.shells + 1};
    }
  }
  std::map<const Shell*, std::vector<std::size_t>> result;
  for (const auto& [grids, side] : sides) {
    if (side.shells == 1) result[side.shell].push_back(side.from);
  }
  return result;
}

// The section, less twisting stiffness along the sides given.
ShellSection with_layers(const ShellSection& section,
                         const std::vector<Vector3d>& corners,
                         const std::vector<std::size_t>& sides) {
  const std::size_t n = corners.size();
  const Vector3d x = (corners[1] - corners[0]).normalized();
  const Vector3d area =
      0.5 * (corners[n == 4 ? 2 : 1] - corners[0])
                .cross(corners[n - 1] - corners[n == 4 ? 1 : 0]);
  const Vector3d y = area.normalized().cross(x);
  ShellSection left = section;
  for (const std::size_t k : sides) {
    const Vector3d side = corners[(k + 1) % n] - corners[k];
    const Vector2d s = Vector2d(side.dot(x), side.dot(y)).normalized();
    // A unit of 2 k_sn, in the element's axes.
    const Vector3d twist(
        -s.x() * s.y(), s.x() * s.y(), s.x() * s.x() - s.y() * s.y());
    const double D = twist.dot(section.bending * twist);
    const double delta = std::sqrt(D * s.dot(section.shear_compliance * s));
    const double share =
        std::min(delta * side.norm() / area.norm(), most_taken);
    // What moments are there to that strain: its dual.
    const Vector3d dual(-2.0 * s.x() * s.y(),
                        2.0 * s.x() * s.y(),
                        s.x() * s.x() - s.y() * s.y());
    left.bending -= share * D * dual * dual.transpose();
  }
  return left;
}

}  // namespace

SparseMatrix free_edge_layer(const Deck& deck) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [shell, sides] : free_sides(deck)) {
    // Others have no layer of this kind, or are told from their corners only.
    const ShellProperty& p = deck.shell_properties.at(shell->property);
    if (p.panel || !p.plies.empty() || !shell->mids.empty()) continue;
    const ShellSection section = shell_section(deck, *shell);
    if (section.shear_compliance.isZero(0.0)) continue;
    std::vector<Vector3d> corners;
    std::vector<int> first;
    for (const int grid : shell->grids) {
      const std::size_t index = deck.grid_index(grid);
      corners.push_back(deck.grids[index].position);
      first.push_back(6 * static_cast<int>(index));
    }
    const Eigen::MatrixXd K =
        shell_matrices(deck, *shell, section).K -
        shell_matrices(deck, *shell, with_layers(section, corners, sides)).K;
    for (Eigen::Index i = 0; i < K.rows(); ++i) {
      for (Eigen::Index j = 0; j < K.cols(); ++j) {
        if (K(i, j) == 0.0) continue;
        entries.emplace_back(first[static_cast<std::size_t>(i / 6)] + i % 6,
                             first[static_cast<std::size_t>(j / 6)] + j % 6,
                             K(i, j));
      }
    }
  }
  const auto dofs = 6 * static_cast<Eigen::Index>(deck.grids.size());
  SparseMatrix K(dofs, dofs);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

}  // namespace tapfit::structure
