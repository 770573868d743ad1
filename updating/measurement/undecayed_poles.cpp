#include "updating/measurement/undecayed_poles.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace tapfit::updating {

Eigen::VectorXcd undecayed_poles(const modal::ModeSet& modes,
                                 const acquisition::HitSet& hits) {
  const double block_s = static_cast<double>(hits.block) / hits.sample_rate_hz;
  std::vector<std::complex<double>> poles;
  const auto add = [&](const std::complex<double>& pole) {
    const double left = std::exp(pole.real() * block_s);
    // Modes may share a pole.
    const bool there = std::ranges::find(poles, pole) != poles.end();
    if (left > 1e-3 && left < 1.0 && !there) poles.push_back(pole);
  };
  for (const modal::Mode& mode : modes.modes) add(mode.pole);
  for (const std::complex<double>& pole : modes.unresolved) add(pole);
  std::ranges::sort(poles, {}, [](const auto& pole) { return pole.imag(); });
  return Eigen::Map<Eigen::VectorXcd>(poles.data(),
                                      static_cast<Eigen::Index>(poles.size()));
}

bool have_converged(const Eigen::VectorXcd& before,
                    const Eigen::VectorXcd& after) {
  if (before.size() != after.size()) return false;
  const Eigen::ArrayXd moved = (after - before).cwiseAbs().array();
  return (moved <= 0.01 * after.real().cwiseAbs().array()).all();
}

}  // namespace tapfit::updating
