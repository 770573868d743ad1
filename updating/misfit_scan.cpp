#include "updating/misfit_scan.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

MisfitScan::MisfitScan(const Fit& current, const Target& target)
    : target_(&target) {
  const ModelResponse response =
      current.model->respond(current.result.state, target.s, true);
  missing_ = response.H - target.H;
  misfit_ = stack(target, missing_);
  if (response.dH.empty()) return;
  MatrixXd J(misfit_.size(), static_cast<Index>(response.dH.size()));
  for (std::size_t k = 0; k < response.dH.size(); ++k) {
    J.col(static_cast<Index>(k)) = stack(target, response.dH[k]);
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(J);
  qr.setThreshold(1e-8);
  Q_ = qr.householderQ() * MatrixXd::Identity(J.rows(), qr.rank());
  misfit_ -= (Q_ * (Q_.transpose() * misfit_)).eval();
}

VectorXd MisfitScan::change(const MatrixXcd& dH) const {
  return stack(*target_, dH);
}

// ||m + P c||^2 with P the projection off Q and m = P m.
VectorXd MisfitScan::errors(const MatrixXd& changes) const {
  VectorXd square =
      (changes.transpose() * misfit_ * 2.0).array() + misfit_.squaredNorm();
  square += changes.colwise().squaredNorm().transpose();
  if (Q_.size() > 0) {
    square -= (Q_.transpose() * changes).colwise().squaredNorm().transpose();
  }
  return square.cwiseMax(0.0).cwiseSqrt();
}

MisfitScan::Scaled MisfitScan::scaled(const VectorXd& change) const {
  const double all = misfit_.squaredNorm();
  double power = change.squaredNorm();
  // Nearly all of it may be what the other parameters do as well.
  const double least = 1e-6 * power;
  if (Q_.size() > 0) power -= (Q_.transpose() * change).squaredNorm();
  const double along = -misfit_.dot(change);
  if (along <= 0.0 || power <= least) return {0.0, std::sqrt(all)};
  return {along / power, std::sqrt(std::max(all - along * along / power, 0.0))};
}

double MisfitScan::any_law(const MatrixXcd& pattern) const {
  double left = 0.0;
  for (Index l = 0; l < pattern.rows(); ++l) {
    const VectorXcd p = pattern.row(l).transpose();
    const VectorXcd m = missing_.row(l).transpose();
    const double power = std::max(p.squaredNorm(), 1e-300);
    const double rest = m.squaredNorm() - std::norm(p.dot(m)) / power;
    left += std::max(rest, 0.0) / std::pow(target_->weight(l), 2);
  }
  return std::sqrt(left / std::max(target_->count(), 1.0));
}

}  // namespace tapfit::updating
