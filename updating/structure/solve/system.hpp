// Stiffness and mass matrices of a deck.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/SparseCore>

#include <functional>
#include <vector>

namespace tapfit::structure {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Matrices over all degrees of freedom u, six per grid along basic axes:
/// index = 6 * grid_index + component - 1. Constraints are not applied here but
/// listed, so that a support can be given some compliance later. Rigid elements
/// and turned grids are in u = T q, q numbered alike (see rigid_motion.hpp).
struct System {
  SparseMatrix K;           ///< full symmetric storage [N/m]
  SparseMatrix M;           ///< [kg]
  std::vector<bool> fixed;  ///< of q: held by a constraint
  std::vector<bool>
      inactive;         ///< of q: follows, or without stiffness (AUTOSPC)
  SparseMatrix T = {};  ///< dofs square; 0 x 0 where u = q

  [[nodiscard]] Eigen::Index dofs() const { return K.rows(); }
  /// Indices of q that are neither fixed nor inactive.
  [[nodiscard]] std::vector<int> free_dofs() const;
};

/// Assembles every element of the deck.
///
/// @throws InputError naming the element for a bad shape (zero area, wrong
///   node order) or missing property
[[nodiscard]] System assemble(const Deck& deck);

/// Stiffness (or mass) of only the shells, bars and rods that `wanted` accepts
/// by element id (asked on several threads); for groups and local losses.
[[nodiscard]] SparseMatrix assemble_stiffness(
    const Deck& deck, const std::function<bool(int element_id)>& wanted);
[[nodiscard]] SparseMatrix assemble_mass(
    const Deck& deck, const std::function<bool(int element_id)>& wanted);

/// Ids of the elements whose material is the one given.
[[nodiscard]] std::vector<int> elements_of_material(const Deck& deck, int id);

/// Total mass in translation [kg].
[[nodiscard]] double total_mass(const Deck& deck, const System& system);

}  // namespace tapfit::structure
