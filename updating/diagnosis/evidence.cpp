#include "updating/diagnosis/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tapfit::updating {

double evidence_data(const Target& target,
                     const Eigen::VectorXd& residual,
                     int modes_in_band) {
  const double frfs =
      std::accumulate(target.use.begin(), target.use.end(), 0.0);
  const double modes = std::max(1, modes_in_band);
  const double most =
      std::min(effective_data(target), modes * (2.0 * frfs + 1.0));
  return std::clamp(
      residual_data(target, residual), std::min(4.0 * modes, most), most);
}

FormShare form_share(const Fit& fit, double data, double noise) {
  constexpr double plausible = 0.02;
  const FormEstimate form = estimate_form(fit.form, data, noise);
  const double error = fit.result.error;
  const double sd = 0.5 * form.tau;
  if (sd > plausible) return {sd, 0.0, error};
  const double left = std::min(form.left, error);
  return {sd, std::sqrt((error - left) * (error + left)), left};
}

double log_evidence(const Fit& fit,
                    double parameters,
                    double places,
                    double data,
                    double noise) {
  return estimate_form(fit.form, data, noise).log_likelihood -
         0.5 * fit.result.prior_cost - 0.5 * parameters * std::log(data) -
         std::log(std::max(places, 1.0));
}

std::vector<double> probabilities(const std::vector<double>& log_evidences) {
  if (log_evidences.empty()) return {};
  const double top =
      *std::max_element(log_evidences.begin(), log_evidences.end());
  std::vector<double> p;
  double sum = 0.0;
  for (const double e : log_evidences) {
    p.push_back(std::exp(e - top));
    sum += p.back();
  }
  for (double& x : p) x /= sum;
  return p;
}

}  // namespace tapfit::updating
