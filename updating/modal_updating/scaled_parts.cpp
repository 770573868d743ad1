#include "updating/modal_updating/scaled_parts.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using structure::SparseMatrix;

bool is_nothing(const SparseMatrix& A) {
  return A.size() == 0 || A.norm() == 0.0;
}

void check_matrix(const SparseMatrix& A, Index n, const std::string& name) {
  if (A.rows() != n || A.cols() != n) {
    throw InputError(
        fmt::format(
            "the matrix is {} x {}, not {} x {}", A.rows(), A.cols(), n, n),
        name,
        "All matrices are over the same free degrees of freedom.");
  }
  const double size = A.norm();
  if (!std::isfinite(size)) {
    throw InputError("the matrix holds entries that are not numbers",
                     name,
                     "Look for inf or nan in what it was read from.");
  }
  // Rounding of whoever wrote the matrix.
  if ((A - SparseMatrix(A.transpose())).norm() > 1e-8 * size) {
    throw InputError("the matrix is not symmetric",
                     name,
                     "Give the whole matrix or, if it is stored as one "
                     "triangle, say so in the file.");
  }
}

}  // namespace

SparseMatrix ScaledModel::stiffness(const Eigen::VectorXd& theta) const {
  SparseMatrix K = K0;
  for (std::size_t j = 0; j < parts.size(); ++j) {
    if (parts[j].K.rows() == 0) continue;
    K += theta(static_cast<Index>(j)) * parts[j].K;
  }
  return K;
}

SparseMatrix ScaledModel::mass(const Eigen::VectorXd& theta) const {
  SparseMatrix M = M0;
  for (std::size_t j = 0; j < parts.size(); ++j) {
    if (parts[j].M.rows() == 0) continue;
    M += theta(static_cast<Index>(j)) * parts[j].M;
  }
  return M;
}

void check(const ScaledModel& model) {
  const Index n = model.K0.rows();
  check_matrix(model.K0, n, "stiffness matrix");
  check_matrix(model.M0, n, "mass matrix");
  for (const ScaledPart& part : model.parts) {
    if (is_nothing(part.K) && is_nothing(part.M)) {
      throw InputError("the part has neither stiffness nor mass",
                       fmt::format("part \"{}\"", part.name),
                       "Give it a matrix, or leave it out.");
    }
    if (part.K.rows() > 0) {
      check_matrix(part.K, n, fmt::format("stiffness of \"{}\"", part.name));
    }
    if (part.M.rows() > 0) {
      check_matrix(part.M, n, fmt::format("mass of \"{}\"", part.name));
    }
  }
}

}  // namespace tapfit::updating
