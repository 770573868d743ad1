// The room updating/structure/elements. Stiffness and mass of one element.
// In:  An element of the deck with its grids and properties, in SI.
// Out: Dense matrices in basic axes.
// May include: its row in CONTRIBUTING.md.
//
// Stiffness and mass of one element over the six degrees of freedom of each of
// its grids, in basic axes.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::structure {

struct ShellSection;

struct ElementMatrices {
  std::vector<int> grids;
  Eigen::MatrixXd K;  ///< 6n x 6n [N/m, N, N m]
  Eigen::MatrixXd M;  ///< 6n x 6n [kg, kg m, kg m^2]; before WTMASS
};

/// A shell of any kind, by its mids and its property.
/// @throws InputError naming the element for a bad shape
[[nodiscard]] ElementMatrices shell_matrices(const Deck& deck,
                                             const Shell& shell);

/// The same of a section that is not the deck's.
[[nodiscard]] ElementMatrices shell_matrices(const Deck& deck,
                                             const Shell& shell,
                                             const ShellSection& section);

/// CQUAD8 or CTRIA6: shell_matrices() of a shell with mids.
[[nodiscard]] ElementMatrices quadratic_matrices(const Deck& deck,
                                                 const Shell& shell,
                                                 const ShellSection& section);

/// CSHEAR: shell_matrices() of a shell whose property is a panel.
[[nodiscard]] ElementMatrices panel_matrices(const Deck& deck,
                                             const Shell& shell);

/// CHEXA, CPENTA, CPYRAM, CTETRA.
/// @throws InputError naming the element for one that is turned inside out
[[nodiscard]] ElementMatrices solid_matrices(const Deck& deck,
                                             const Solid& solid);

/// CBAR or CBEAM. @throws InputError for a bar without length
[[nodiscard]] ElementMatrices bar_matrices(const Deck& deck, const Bar& bar);

/// CROD, CTUBE or CONROD. @throws InputError for a rod without length
[[nodiscard]] ElementMatrices rod_matrices(const Deck& deck, const Rod& rod);

/// CONM1, CONM2: mass only.
[[nodiscard]] ElementMatrices mass_matrices(const PointMass& mass);

/// CELAS, CMASS, CBUSH1D; damping is not part of K or M.
[[nodiscard]] ElementMatrices scalar_matrices(const ScalarElement& scalar);

/// CBUSH; damping is not part of K or M.
[[nodiscard]] ElementMatrices bush_matrices(const Bush& bush);

/// What its springs along and about x, y, z are stretched by, 6 x 6n,
/// n = grids that are not 0.
[[nodiscard]] Eigen::MatrixXd bush_strains(const Bush& bush);

/// The direction of a scalar element over the degrees of freedom of its
/// grids: u2 - u1, or u alone against ground. 6n, n = grids that are not 0.
[[nodiscard]] Eigen::VectorXd scalar_direction(const ScalarElement& scalar);

}  // namespace tapfit::structure
