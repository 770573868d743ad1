#include "updating/comparison/form_share.hpp"

#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

FormShare form_share(const Fit& fit, const Target& target, double noise) {
  if (!fit.form.has_patterns()) {
    return {0.0, 0.0, fit.result.error, 0.0};
  }
  constexpr double plausible = 0.02;
  const double data = independent_data(target, fit.result.residual);
  const FormEstimate form = estimate_form(fit.form, data, noise);
  const double error = fit.result.error;
  const double sd = 0.5 * form.tau;
  const double left = std::min(form.left, error);
  const double explained = std::sqrt((error - left) * (error + left));
  const double middle = 0.5 * middle_tau * fit.form.allowance;
  const double usual = explained * std::min(1.0, middle / sd);
  if (sd > plausible) return {sd, 0.0, error, usual};
  // What is missing looks like a form that is further off than careful decks
  // are: of that no more than theirs is the form's.
  constexpr double spread = 3.0;  // one deviation of the prior of tau
  const double share = explained * std::min(1.0, spread * middle / sd);
  return {sd, share, left, usual};
}

}  // namespace tapfit::updating
