#include "signal/checks/confidence_band.hpp"

#include <cmath>

namespace tapfit::signal {

Eigen::VectorXd confidence_radius(const Frf& frf, double outside) {
  const double n = frf.variance_freedom;
  const double squared = std::isfinite(n)
                             ? 0.5 * n * (std::pow(outside, -2.0 / n) - 1.0)
                             : -std::log(outside);
  return (squared * frf.variance.array().max(0.0)).sqrt();
}

Eigen::VectorXd confidence_reach(const Frf& frf) {
  const double n = frf.variance_freedom;
  const double z = 1.959964;
  // t of the normal's quantile (Cornish and Fisher; 2e-4 off at n = 24).
  const double z3 = z * z * z;
  const double t = z + (z3 + z) / (4.0 * n) +
                   (5.0 * z3 * z * z + 16.0 * z3 + 3.0 * z) / (96.0 * n * n);
  return (0.5 * t * t * frf.variance.array().max(0.0)).sqrt();
}

}  // namespace tapfit::signal
