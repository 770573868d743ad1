#include "updating/comparison/form_share.hpp"

#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

FormShare form_share(const Fit& fit,
                     const Target& target,
                     int modes,
                     double noise) {
  if (fit.form.lambda.size() == 0) {
    return {0.0, 0.0, fit.result.error};
  }
  constexpr double plausible = 0.02;
  const double data = independent_data(target, fit.result.residual, modes);
  const FormEstimate form = estimate_form(fit.form, data, noise);
  const double error = fit.result.error;
  const double sd = 0.5 * form.tau;
  if (sd > plausible) return {sd, 0.0, error};
  const double left = std::min(form.left, error);
  return {sd, std::sqrt((error - left) * (error + left)), left};
}

}  // namespace tapfit::updating
