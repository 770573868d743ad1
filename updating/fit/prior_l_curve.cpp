#include "updating/fit/prior_l_curve.hpp"

#include <Eigen/QR>

#include <cmath>
#include <vector>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::optional<LCurve> prior_l_curve(const UpdateResult& result) {
  std::vector<Index> held;
  std::vector<Index> free;
  for (Index k = 0; k < result.prior.sd.size(); ++k) {
    (std::isfinite(result.prior.sd(k)) ? held : free).push_back(k);
  }
  const MatrixXd& J = result.jacobian;
  if (held.empty() || J.rows() < J.cols()) return std::nullopt;
  const VectorXd sd = result.prior.sd(held);
  const VectorXd x =
      (pack(result.state) - result.prior.mean)(held).cwiseQuotient(sd);
  MatrixXd S = J(Eigen::all, held) * sd.asDiagonal();
  VectorXd r = result.residual;
  if (!free.empty()) {
    const Eigen::HouseholderQR<MatrixXd> qr(MatrixXd(J(Eigen::all, free)));
    const MatrixXd span =
        qr.householderQ() *
        MatrixXd::Identity(J.rows(), static_cast<Index>(free.size()));
    S -= span * (span.transpose() * S).eval();
    r -= span * (span.transpose() * r).eval();
  }
  const VectorXd d = S * x - r;
  const TikhonovSystem system(S, d);
  LCurve curve = system.l_curve();
  const VectorXd solved = system.solve(result.lambda);
  curve.used = {result.lambda, (S * solved - d).norm(), solved.norm()};
  return curve;
}

}  // namespace tapfit::updating
