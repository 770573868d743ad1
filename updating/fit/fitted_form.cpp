#include "updating/fit/fitted_form.hpp"

#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;

namespace {

// A deck's modes are off more alike than apart: shells are too soft, or too
// stiff, in all of them. Over structures of solids half as much again.
constexpr double shared_tau = 1.5 * middle_tau;

}  // namespace

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

Index common_patterns(const Target& target) {
  return target.is_modal() ? 2 : 3;
}

Eigen::MatrixXd likely_form_bias(const FormError& form,
                                 double tau,
                                 double allowance,
                                 const Target& target) {
  const double common = std::max(tau, shared_tau * allowance);
  Eigen::VectorXd sd = (form.mesh_sd.array().square() + tau * tau).sqrt();
  sd.segment(sd.size() - common_patterns(target), 2).setConstant(common);
  return form.F * sd.asDiagonal();
}

Readjustment readjustment(const UpdateResult& result) {
  const Prior& prior = result.prior;
  const Eigen::VectorXd theta = pack(result.state);
  const Residuals known = prior_residuals(prior, theta);
  Readjustment fit{result.jacobian,
                   known.J.transpose() * known.J,
                   known.J.transpose() * known.r};
  constexpr double touching = 1e-6;
  for (Index k = 0; k < theta.size(); ++k) {
    const bool bound = theta(k) < prior.lower(k) + touching ||
                       theta(k) > prior.upper(k) - touching;
    if (!bound) continue;
    fit.J.col(k).setZero();
    fit.information.col(k).setZero();
    fit.information.row(k).setZero();
    fit.pull(k) = 0.0;
  }
  return fit;
}

FittedForm fitted_form(const FrfModel& model,
                       const UpdateResult& result,
                       const Target& target,
                       double allowance) {
  const FormError patterns = form_error(model, result.state, target);
  FittedForm fitted;
  fitted.view = view(patterns, result.residual, readjustment(result));
  fitted.view.allowance = allowance;
  const FormEstimate form =
      estimate_form(fitted.view, most_data(target), noise_error(target));
  fitted.log_likelihood = form.log_likelihood;
  fitted.bias = likely_form_bias(patterns, form.mean_tau, allowance, target);
  return fitted;
}

}  // namespace tapfit::updating
