#include "modal/mac.hpp"

namespace tapfit::modal {

Eigen::MatrixXd mac(const Eigen::MatrixXcd& U, const Eigen::MatrixXcd& V) {
  const Eigen::MatrixXcd inner = U.adjoint() * V;
  const Eigen::VectorXd uu = U.colwise().squaredNorm().transpose();
  const Eigen::VectorXd vv = V.colwise().squaredNorm().transpose();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(U.cols(), V.cols());
  for (Eigen::Index i = 0; i < U.cols(); ++i) {
    for (Eigen::Index j = 0; j < V.cols(); ++j) {
      if (uu(i) > 0.0 && vv(j) > 0.0) {
        result(i, j) = std::norm(inner(i, j)) / uu(i) / vv(j);
      }
    }
  }
  return result.cwiseMin(1.0);
}

Eigen::VectorXd comac(const Eigen::MatrixXcd& U, const Eigen::MatrixXcd& V) {
  // |u conj(v)| takes the phase of each pair out of the sum.
  const Eigen::VectorXd cross =
      (U.array() * V.array().conjugate()).abs().rowwise().sum().matrix();
  const Eigen::VectorXd uu = U.rowwise().squaredNorm();
  const Eigen::VectorXd vv = V.rowwise().squaredNorm();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(U.rows());
  for (Eigen::Index k = 0; k < U.rows(); ++k) {
    if (uu(k) > 0.0 && vv(k) > 0.0) {
      result(k) = cross(k) * cross(k) / uu(k) / vv(k);
    }
  }
  return result.cwiseMin(1.0);
}

}  // namespace tapfit::modal
