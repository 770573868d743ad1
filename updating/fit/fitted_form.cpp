#include "updating/fit/fitted_form.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;

FormError form_error(const FrfModel& model,
                     const ModelState& state,
                     const Target& target) {
  FormPatterns patterns = model.form_patterns(state, target.s);
  const Index rows = residual(target, target.H).size();
  Eigen::MatrixXd F(rows, std::ssize(patterns.dH));
  for (Index k = 0; k < F.cols(); ++k) {
    F.col(k) = stack(target, patterns.dH[static_cast<std::size_t>(k)]);
  }
  return {std::move(F), std::move(patterns.mesh_sd)};
}

Eigen::MatrixXd likely_form_bias(const FormError& form,
                                 double tau,
                                 double allowance,
                                 const Target& target) {
  const double common = std::max(tau, middle_tau * allowance);
  // The last: even, linear and, in FRFs, of the modes above the band.
  const Index above = target.is_modal() ? 0 : 1;
  Eigen::VectorXd sd = (form.mesh_sd.array().square() + tau * tau).sqrt();
  sd.segment(sd.size() - 2 - above, 2).setConstant(common);
  return form.F * sd.asDiagonal();
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
