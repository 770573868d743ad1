// The room updating/structure/solve. Sparse linear algebra: factorisation,
// eigenmodes, motions that constraints leave.
// In:  Sparse matrices.
// Out: Solutions, modes, or an InputError for matrices of no structure. Decks
//      are not known here.
// May include: its row in CONTRIBUTING.md.
//
// Undamped modes: K phi = omega^2 M phi, Spectra in shift-invert mode.
#pragma once

#include "updating/structure/solve/system.hpp"

#include <stop_token>

namespace tapfit::structure {

struct Eigenmodes {
  Eigen::VectorXd frequency_hz;  ///< ascending; rigid modes are near 0
  Eigen::MatrixXd phi;           ///< n_free x count, phi' M phi = I
};

/// Modes with the lowest frequencies.
///
/// @param K, M over the free degrees of freedom only; K may be singular
///   (free structures): the shift is chosen below zero
/// @param count number of modes; cut to what the matrices have
/// @param stop looked at between two solutions: then Stopped is thrown
/// @throws InputError when the solver does not converge, or K or M is not
///   positive semidefinite
[[nodiscard]] Eigenmodes eigenmodes(const SparseMatrix& K,
                                    const SparseMatrix& M,
                                    Eigen::Index count,
                                    const std::stop_token& stop = {});

/// All modes up to a frequency, found by asking for more until one lies above.
[[nodiscard]] Eigenmodes eigenmodes_up_to(const SparseMatrix& K,
                                          const SparseMatrix& M,
                                          double max_hz,
                                          const std::stop_token& stop = {});

}  // namespace tapfit::structure
