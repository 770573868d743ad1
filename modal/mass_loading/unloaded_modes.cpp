#include "modal/mass_loading/unloaded_modes.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;

/// Which eigenvector is which mode: the largest overlap first, each once.
Eigen::VectorXi match(const Eigen::MatrixXd& vectors) {
  Eigen::MatrixXd overlap = vectors.cwiseAbs2();
  for (Index c = 0; c < overlap.cols(); ++c) {
    overlap.col(c) /= overlap.col(c).sum();
  }
  Eigen::VectorXi vector_of(overlap.rows());
  for (Index n = 0; n < overlap.rows(); ++n) {
    Index mode = 0;
    Index vector = 0;
    overlap.maxCoeff(&mode, &vector);
    vector_of(mode) = static_cast<int>(vector);
    overlap.row(mode).setConstant(-1.0);
    overlap.col(vector).setConstant(-1.0);
  }
  return vector_of;
}

}  // namespace

std::optional<UnloadedModes> unload(const Eigen::VectorXd& log_omega,
                                    const std::vector<Eigen::MatrixXd>& phi,
                                    const Eigen::VectorXd& kg) {
  const Index n = log_omega.size();
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(n, n);
  for (std::size_t q = 0; q < phi.size(); ++q) {
    M -= kg(static_cast<Index>(q)) * phi[q].transpose() * phi[q];
  }
  if (Eigen::LLT<Eigen::MatrixXd>(M).info() != Eigen::Success) {
    return std::nullopt;
  }
  const Eigen::VectorXd squares = (2.0 * log_omega.array()).exp();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      squares.asDiagonal().toDenseMatrix(), M);
  if (eigen.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXi vector_of = match(eigen.eigenvectors());
  UnloadedModes result;
  result.log_omega.resize(n);
  result.derivative.resize(n, static_cast<Index>(phi.size()));
  result.vectors.resize(n, n);
  for (Index r = 0; r < n; ++r) {
    // Eigenvectors come with v' M v = 1.
    const Eigen::VectorXd v = eigen.eigenvectors().col(vector_of(r));
    result.vectors.col(r) = v(r) < 0.0 ? Eigen::VectorXd(-v) : v;
    const double square = eigen.eigenvalues()(vector_of(r));
    if (!(square > 0.0)) return std::nullopt;
    result.log_omega(r) = 0.5 * std::log(square);
    for (std::size_t q = 0; q < phi.size(); ++q) {
      result.derivative(r, static_cast<Index>(q)) =
          0.5 * (phi[q] * v).squaredNorm();
    }
  }
  return result;
}

}  // namespace tapfit::modal
