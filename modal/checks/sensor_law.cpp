#include "modal/checks/sensor_law.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

// A twentieth of a block of one second: of what is later still, the block cuts
// off too much for its modes to be compared.
constexpr double longest_delay_s = 0.05;

// |Re sum conj(seen) z| with the delay taken off: g is the same for all modes,
// and real.
double common(const VectorXcd& z,
              const VectorXcd& seen,
              const VectorXcd& poles,
              double delay_s) {
  const VectorXcd late =
      seen.cwiseProduct((-delay_s * poles).array().exp().matrix());
  return std::abs(late.dot(z).real()) / std::max(late.norm(), 1e-300);
}

// Up to the longest either way.
double best_delay(const VectorXcd& z,
                  const VectorXcd& seen,
                  const VectorXcd& poles,
                  double longest_s) {
  constexpr double per_period = 16.0;
  const double highest = poles.imag().cwiseAbs().maxCoeff();
  if (highest <= 0.0) return 0.0;
  double step = 2.0 * M_PI / highest / per_period;
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
  look(0.0, static_cast<int>(longest_s / step));
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
  // Integrators and the filters behind them lag by a sample or so.
  const double highest = std::max(poles.imag().cwiseAbs().maxCoeff(), 1e-300);
  const double slight_s =
      std::min(0.25 * 2.0 * M_PI / highest, longest_delay_s);
  std::vector<SensorLaw> laws;
  for (const int power : {-1, -2, 1, 2}) {
    SensorLaw law{power, 0.0};
    const VectorXcd by_power = seen.cwiseProduct(law.factors(poles));
    law.delay_s = best_delay(z, by_power, poles, slight_s);
    laws.push_back(law);
  }
  laws.push_back({0, best_delay(z, seen, poles, longest_delay_s)});
  return laws;
}

}  // namespace tapfit::modal
