#include "updating/localisation/projected_misfit.hpp"

#include "updating/residual/independent_data.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// What is known of the parameters before, as rows of a residual. Else what
// readjusts would explain whatever is there, corrections beyond all that a deck
// is off by among it.
Residuals prior_rows(const Fit& current,
                     const Target& target,
                     double residual,
                     Index parameters) {
  const Prior& prior = current.result.prior;
  if (prior.sd.size() != parameters) {
    return {VectorXd(0), MatrixXd(0, parameters)};
  }
  // More than all of what was measured is no scatter: a model in other units
  // would have its priors count a thousandfold once they are put right.
  const double unit =
      std::min(residual, 1.0) / std::sqrt(effective_data(target));
  Residuals rows = prior_residuals(prior, pack(current.result.state));
  rows.r *= unit;
  rows.J *= unit;
  return rows;
}

}  // namespace

ProjectedMisfit::ProjectedMisfit(const Fit& current, const Target& target)
    : target_(&target) {
  const ModelResponse response =
      current.model->respond(current.result.state, target.s, true);
  const VectorXd data = stack(target, response.H - target.H);
  const auto n = static_cast<Index>(response.dH.size());
  const Residuals prior =
      prior_rows(current, target, residual(target, response.H).norm(), n);
  VectorXd all(data.size() + prior.r.size());
  all.head(data.size()) = data;
  all.tail(prior.r.size()) = prior.r;
  MatrixXd Q(all.size(), 0);
  if (n > 0) {
    MatrixXd J(all.size(), n);
    for (Index k = 0; k < n; ++k) {
      J.col(k).head(data.size()) =
          stack(target, response.dH[static_cast<std::size_t>(k)]);
    }
    J.bottomRows(prior.r.size()) = prior.J;
    Eigen::ColPivHouseholderQR<MatrixXd> qr(J);
    qr.setThreshold(1e-8);
    Q = qr.householderQ() * MatrixXd::Identity(J.rows(), qr.rank());
  }
  const VectorXd left = all - Q * (Q.transpose() * all);
  misfit_power_ = left.squaredNorm();
  missing_power_ = data.squaredNorm();
  // Changes of the response have nothing in the prior's rows.
  directions_.resize(data.size(), tangent + Q.cols());
  directions_.col(misfit) = left.head(data.size());
  directions_.col(missing) = data;
  directions_.rightCols(Q.cols()) = Q.topRows(data.size());
}

VectorXd ProjectedMisfit::change(const MatrixXcd& dH) const {
  return stack(*target_, dH);
}

double ProjectedMisfit::unchanged() const { return std::sqrt(misfit_power_); }

// ||m + P c||^2 with P the projection off Q and m = P m.
VectorXd ProjectedMisfit::errors(const VectorXd& power,
                                 const MatrixXd& shared) const {
  const Index readjusting = shared.rows() - tangent;
  VectorXd square = power + 2.0 * shared.row(misfit).transpose();
  square.array() += misfit_power_;
  square -= shared.bottomRows(readjusting).colwise().squaredNorm().transpose();
  return square.cwiseMax(0.0).cwiseSqrt();
}

VectorXd ProjectedMisfit::errors(const MatrixXd& changes) const {
  return errors(changes.colwise().squaredNorm().transpose(),
                directions_.transpose() * changes);
}

ProjectedMisfit::Scaled ProjectedMisfit::scaled(double power,
                                                const VectorXd& shared) const {
  // Nearly all of it may be what the other parameters do as well.
  const double least = 1e-6 * power;
  const double left =
      power - shared.tail(shared.size() - tangent).squaredNorm();
  const double along = -shared(misfit);
  if (along <= 0.0 || left <= least) return {0.0, unchanged()};
  return {along / left,
          std::sqrt(std::max(misfit_power_ - along * along / left, 0.0))};
}

}  // namespace tapfit::updating
