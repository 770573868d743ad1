#include "updating/fit/fitted_form.hpp"

#include <algorithm>
#include <vector>

namespace tapfit::updating {

using Eigen::Index;

Eigen::MatrixXd form_bias(const FrfModel& model,
                          const ModelState& state,
                          const Target& target) {
  const std::vector<Eigen::MatrixXcd> patterns =
      model.form_patterns(state, target.s);
  const Index rows = residual(target, target.H).size();
  Eigen::MatrixXd F(rows, static_cast<Index>(patterns.size()));
  for (std::size_t k = 0; k < patterns.size(); ++k) {
    F.col(static_cast<Index>(k)) = stack(target, patterns[k]);
  }
  return F;
}

Eigen::MatrixXd likely_form_bias(Eigen::MatrixXd patterns,
                                 double tau,
                                 double allowance,
                                 const Target& target) {
  const double common = std::max(tau, middle_tau * allowance);
  // The last: even, linear and, in FRFs, of the modes above the band.
  const Index above = target.is_modal() ? 0 : 1;
  const Index first = patterns.cols() - 2 - above;
  patterns.leftCols(first) *= tau;
  patterns.middleCols(first, 2) *= common;
  patterns.rightCols(above) *= tau;
  return patterns;
}

Readjustment readjustment(const UpdateResult& result) {
  const Prior& prior = result.prior;
  const Eigen::VectorXd theta = pack(result.state);
  Readjustment fit{result.jacobian, precision(prior), {}};
  fit.pull.setZero(theta.size());
  constexpr double touching = 1e-6;
  for (Index k = 0; k < theta.size(); ++k) {
    fit.pull(k) = fit.precision(k) * (theta(k) - prior.mean(k));
    const bool bound = theta(k) < prior.lower(k) + touching ||
                       theta(k) > prior.upper(k) - touching;
    if (!bound) continue;
    fit.J.col(k).setZero();
    fit.pull(k) = 0.0;
  }
  return fit;
}

}  // namespace tapfit::updating
