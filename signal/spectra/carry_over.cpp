#include "signal/spectra/carry_over.hpp"

#include "signal/spectra/decays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::signal {

using Eigen::Index;

Stretch carry_over_stretch(const Eigen::VectorXcd& poles,
                           double fs,
                           const Stretch& before) {
  if (poles.size() == 0) return {};
  // Twelve periods of the slowest pole fix its amplitude and phase; more would
  // only ask for more digits of the poles.
  const double slowest = poles.cwiseAbs().minCoeff() / (2.0 * std::numbers::pi);
  const auto wanted = static_cast<Index>(12.0 * fs / slowest);
  const Stretch fit = {std::max(before.begin, before.end - wanted), before.end};
  // Fewer than two periods, or hardly more samples than unknowns: no fit.
  const auto least = std::max<Index>(static_cast<Index>(2.0 * fs / slowest),
                                     4 * (2 * poles.size() + 1));
  return fit.length() >= least ? fit : Stretch{};
}

Eigen::VectorXd carry_over(const Eigen::Ref<const Eigen::VectorXd>& channel,
                           const Stretch& fit,
                           const Eigen::VectorXcd& poles,
                           double fs,
                           Index begin,
                           Index n) {
  if (fit.length() == 0 || poles.size() == 0) return Eigen::VectorXd::Zero(n);
  const Eigen::VectorXd a =
      fit_decays(decays(poles, fs, fit.begin, fit.length(), fit.end),
                 channel.segment(fit.begin, fit.length()));
  return decays(poles, fs, begin, n, fit.end) * a;
}

}  // namespace tapfit::signal
