#include "modal/checks/sensor_law.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

constexpr double longest_delay_s = 0.02;

// |sum conj(seen) z| with the delay taken off: g is the same for all modes.
double common(const VectorXcd& z,
              const VectorXcd& seen,
              const VectorXcd& poles,
              double delay_s) {
  const VectorXcd late =
      seen.cwiseProduct((-delay_s * poles).array().exp().matrix());
  return std::abs(late.dot(z)) / std::max(late.norm(), 1e-300);
}

double best_delay(const VectorXcd& z,
                  const VectorXcd& seen,
                  const VectorXcd& poles) {
  constexpr double per_period = 16.0;
  const double highest = poles.imag().cwiseAbs().maxCoeff();
  if (highest <= 0.0) return 0.0;
  double step = 2.0 * M_PI / highest / per_period;
  const auto count = static_cast<int>(longest_delay_s / step);
  double best = 0.0;
  const auto look = [&](double from, int each_side) {
    double most = -1.0;
    for (int i = -each_side; i <= each_side; ++i) {
      const double at = common(z, seen, poles, from + i * step);
      if (at <= most) continue;
      most = at;
      best = from + i * step;
    }
  };
  look(0.0, count);
  for (int turn = 0; turn < 4; ++turn) {
    step /= 4.0;
    look(best, 4);
  }
  return best;
}

}  // namespace

VectorXcd SensorLaw::factors(const VectorXcd& poles) const {
  const double middle =
      std::exp(poles.cwiseAbs().cwiseMax(1e-300).array().log().mean());
  VectorXcd result = (-delay_s * poles).array().exp();
  for (Index k = 0; k < poles.size(); ++k) {
    result(k) *= std::pow(poles(k) / middle, power);
  }
  return result;
}

std::vector<SensorLaw> laws_that_explain(const VectorXcd& z,
                                         const VectorXcd& seen,
                                         const VectorXcd& poles) {
  return {{-1, 0.0},
          {-2, 0.0},
          {1, 0.0},
          {2, 0.0},
          {0, best_delay(z, seen, poles)}};
}

}  // namespace tapfit::modal
