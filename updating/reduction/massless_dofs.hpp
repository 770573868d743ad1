// Degrees of freedom with stiffness but no mass, such as a grid between two
// springs. A base that is orthonormal in the mass has no room for what they do:
// they are lent so little of it that their own frequency,
//
//   omega_i^2 = K_ii / m_i,
//
// lies four decades above the band, where all they do is follow.
#pragma once

#include "updating/structure/solve/bordered_matrix.hpp"
#include "updating/structure/solve/system.hpp"

#include <vector>

namespace tapfit::updating {

/// The mass lent, on the diagonal.
/// @param dofs that are hit, measured, acted on or released; others without
///   mass stay so: where nothing holds them they are a mechanism
/// @param high_hz top of the band; FRFs up to it change by some 1e-8
/// @return n x n; empty where none of them is without mass
[[nodiscard]] structure::SparseMatrix regularising_mass(
    const structure::BorderedMatrix& stiffness,
    const structure::BorderedMatrix& mass,
    const std::vector<int>& dofs,
    double high_hz);

/// The same, of those that neither follow others nor lack stiffness.
[[nodiscard]] structure::SparseMatrix regularising_mass(
    const structure::System& system,
    const std::vector<int>& points,
    double high_hz);

}  // namespace tapfit::updating
