// How many eigenvalues of K x = lambda M x lie below a shift: the number of
// negative pivots of K - shift M = L D L' (Sylvester's law of inertia). With it
// a list of modes is proved to be complete.
//
// Multifrontal: the columns of a supernode and what its children left of the
// rows below are one dense matrix, of which the pivots are counted and the rest
// is handed on. Nothing of L is kept.
//
// Source: I. S. Duff, J. K. Reid, "The multifrontal solution of indefinite
// sparse symmetric linear equations", ACM Trans. Math. Softw. 9, 1983.
#pragma once

#include "updating/structure/solve/system.hpp"

#include <optional>

namespace tapfit::structure {

/// Number of negative eigenvalues of a symmetric matrix.
///
/// Pivots are taken as they come, so the count is that of a matrix that
/// differs by rounding only while they do not get small: the growth is watched.
///
/// @param A full symmetric storage
/// @return empty when a pivot or the growth makes the count uncertain; another
///   shift is then needed
[[nodiscard]] std::optional<Eigen::Index> count_negative(const SparseMatrix& A);

/// Number of eigenvalues of K x = lambda M x below `shift` [rad^2/s^2].
/// @return as above
[[nodiscard]] std::optional<Eigen::Index> count_below(const SparseMatrix& K,
                                                      const SparseMatrix& M,
                                                      double shift);

}  // namespace tapfit::structure
