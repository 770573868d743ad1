#include "updating/diagnosis/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tapfit::updating {

Evidence evidence(const Fit& fit,
                  double parameters,
                  double places,
                  double data,
                  double noise) {
  const FormEstimate form = estimate_form(fit.form, data, noise);
  const double price = 0.5 * fit.result.prior_cost +
                       0.5 * parameters * std::log(data) +
                       std::log(std::max(places, 1.0));
  return {form.log_likelihood - price, form.log_likelihood_if_usual - price};
}

double log_gain(const Evidence& with, const Evidence& without, double left) {
  // A third of the error: nine parts in ten of its square are explained.
  constexpr double little = 1.0 / 3.0;
  const double if_usual = with.log_if_usual - without.log_if_usual;
  return left < little ? std::max(if_usual, with.log - without.log) : if_usual;
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
