#include "updating/structure/solve/definiteness.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/solve/factor.hpp"

#include <fmt/format.h>

namespace tapfit::structure {
bool is_indefinite(const SparseMatrix& A) {
  constexpr double allowed_share = 1e-9;
  // Below this share of the largest diagonal entry, entries may be rounding.
  constexpr double small = 1e-5;
  if (A.rows() == 0) return false;
  const Eigen::VectorXd size = A.diagonal().cwiseAbs();
  const double least = small * size.maxCoeff();
  if (!(least > 0.0)) return A.norm() > 0.0;
  const Eigen::VectorXd scale = size.cwiseMax(least).cwiseSqrt().cwiseInverse();
  SparseMatrix unit = scale.asDiagonal() * A * scale.asDiagonal();
  SparseMatrix allowed(A.rows(), A.cols());
  allowed.setIdentity();
  unit += allowed_share * allowed;
  try {
    return Factor(unit).pivots().minCoeff() < 0.0;
  } catch (const SingularMatrix&) {
    return false;  // not proven
  }
}

void refuse_indefinite(const SparseMatrix& K, const SparseMatrix& M) {
  const bool stiffness = is_indefinite(K);
  if (!stiffness && !is_indefinite(M)) return;
  throw InputError(fmt::format("the {} is not positive: some motion has "
                               "negative energy",
                               stiffness ? "stiffness" : "mass"),
                   stiffness ? "stiffness matrix" : "mass matrix",
                   "Look for springs, elements or masses below zero.");
}

}  // namespace tapfit::structure
