#include "updating/studies/sensitivity.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

LowRankChange factor_change(const MatrixXcd& dZ) {
  const Eigen::ColPivHouseholderQR<MatrixXcd> qr(dZ);
  const Index rank = qr.rank();
  const MatrixXcd R =
      qr.matrixQR().topRows(rank).template triangularView<Eigen::Upper>();
  const MatrixXcd Q = qr.householderQ() * MatrixXcd::Identity(dZ.rows(), rank);
  return {Q, (R * qr.colsPermutation().transpose()).transpose()};
}

namespace {

// H* - H. A core that cancels is measured against what it is made of, because
// a 1 x 1 core always has condition 1.
std::optional<MatrixXcd> receptance_change(const MatrixXcd& H,
                                           const LowRankChange& change) {
  const MatrixXcd HU = H * change.U;
  const MatrixXcd VHU = change.V.transpose() * HU;
  const MatrixXcd core = MatrixXcd::Identity(VHU.rows(), VHU.cols()) + VHU;
  if (core.rows() == 0) return MatrixXcd::Zero(H.rows(), H.cols());
  const Eigen::FullPivLU<MatrixXcd> lu(core);
  const double smallest = lu.matrixLU().diagonal().cwiseAbs().minCoeff();
  if (!(smallest > 1e-13 * (1.0 + VHU.norm()))) return std::nullopt;
  return -HU * lu.solve(change.V.transpose() * H);
}

}  // namespace

std::optional<MatrixXcd> changed_receptance(const MatrixXcd& H,
                                            const LowRankChange& change) {
  std::optional<MatrixXcd> dH = receptance_change(H, change);
  if (dH) *dH += H;
  return dH;
}

std::optional<MatrixXcd> finite_sensitivity(const MatrixXcd& H,
                                            const LowRankChange& dZ,
                                            double dP) {
  std::optional<MatrixXcd> dH = receptance_change(H, dZ);
  if (dH) *dH /= dP;
  return dH;
}

MatrixXcd analytic_sensitivity(const MatrixXcd& H, const MatrixXcd& dZ_dP) {
  return -H * dZ_dP * H;
}

double sensitivity_error(const VectorXcd& exact, const VectorXcd& approximate) {
  double sum = 0.0;
  Index count = 0;
  for (Index k = 0; k < exact.size(); ++k) {
    const double size = std::abs(exact(k));
    if (size == 0.0) continue;
    sum += std::abs(exact(k) - approximate(k)) / size;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace tapfit::updating
