#include "updating/localisation/misfit_scan.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MisfitScan::MisfitScan(const Fit& current, const Target& target)
    : target_(&target) {
  const ModelResponse response =
      current.model->respond(current.result.state, target.s, true);
  const VectorXd all = stack(target, response.H - target.H);
  MatrixXd Q(all.size(), 0);
  if (!response.dH.empty()) {
    MatrixXd J(all.size(), static_cast<Index>(response.dH.size()));
    for (std::size_t k = 0; k < response.dH.size(); ++k) {
      J.col(static_cast<Index>(k)) = stack(target, response.dH[k]);
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(J);
    qr.setThreshold(1e-8);
    Q = qr.householderQ() * MatrixXd::Identity(J.rows(), qr.rank());
  }
  directions_.resize(all.size(), tangent + Q.cols());
  directions_.col(misfit) = all - Q * (Q.transpose() * all);
  directions_.col(missing) = all;
  directions_.rightCols(Q.cols()) = Q;
  misfit_power_ = directions_.col(misfit).squaredNorm();
  missing_power_ = all.squaredNorm();
}

VectorXd MisfitScan::change(const MatrixXcd& dH) const {
  return stack(*target_, dH);
}

// ||m + P c||^2 with P the projection off Q and m = P m.
VectorXd MisfitScan::errors(const VectorXd& power,
                            const MatrixXd& shared) const {
  const Index readjusting = shared.rows() - tangent;
  VectorXd square = power + 2.0 * shared.row(misfit).transpose();
  square.array() += misfit_power_;
  square -= shared.bottomRows(readjusting).colwise().squaredNorm().transpose();
  return square.cwiseMax(0.0).cwiseSqrt();
}

VectorXd MisfitScan::errors(const MatrixXd& changes) const {
  return errors(changes.colwise().squaredNorm().transpose(),
                directions_.transpose() * changes);
}

MisfitScan::Scaled MisfitScan::scaled(double power,
                                      const VectorXd& shared) const {
  // Nearly all of it may be what the other parameters do as well.
  const double least = 1e-6 * power;
  const double left =
      power - shared.tail(shared.size() - tangent).squaredNorm();
  const double along = -shared(misfit);
  if (along <= 0.0 || left <= least) return {0.0, std::sqrt(misfit_power_)};
  return {along / left,
          std::sqrt(std::max(misfit_power_ - along * along / left, 0.0))};
}

}  // namespace tapfit::updating
