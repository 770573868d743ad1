#include "updating/comparison/form_share.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tapfit::updating {

double evidence_data(const Target& target,
                     const Eigen::VectorXd& residual,
                     int modes_in_band) {
  if (target.is_modal()) return effective_data(target);
  const double frfs =
      std::accumulate(target.use.begin(), target.use.end(), 0.0);
  const double modes = std::max(1, modes_in_band);
  const double most =
      std::min(effective_data(target), modes * (2.0 * frfs + 1.0));
  return std::clamp(
      residual_data(target, residual), std::min(4.0 * modes, most), most);
}

FormShare form_share(const Fit& fit, double data, double noise) {
  if (fit.form.lambda.size() == 0) {
    return {0.0, 0.0, fit.result.error};
  }
  constexpr double plausible = 0.02;
  const FormEstimate form = estimate_form(fit.form, data, noise);
  const double error = fit.result.error;
  const double sd = 0.5 * form.tau;
  if (sd > plausible) return {sd, 0.0, error};
  const double left = std::min(form.left, error);
  return {sd, std::sqrt((error - left) * (error + left)), left};
}

}  // namespace tapfit::updating
