#include "signal/checks/calibration.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::signal {
namespace {

using Eigen::Index;

// ln(A m) unwrapped along the lines, so that a delay is a straight line.
Eigen::VectorXcd unwrapped_log(const Eigen::VectorXcd& x) {
  Eigen::VectorXcd result(x.size());
  double turns = 0.0;
  for (Index i = 0; i < x.size(); ++i) {
    double phase = std::arg(x(i)) + turns;
    if (i > 0) {
      const double step = phase - result(i - 1).imag();
      const double whole =
          2.0 * std::numbers::pi * std::round(step / (2.0 * std::numbers::pi));
      phase -= whole;
      turns -= whole;
    }
    result(i) = {std::log(std::abs(x(i))), phase};
  }
  return result;
}

// Weights of the lines: inverse relative variance; alike where none is known.
Eigen::ArrayXd weights_of(const Frf& frf) {
  const Eigen::ArrayXd relative =
      frf.variance.array() / frf.H.cwiseAbs2().array().max(1e-300);
  if (relative.size() == 0 || !(relative.minCoeff() > 0.0)) {
    return Eigen::ArrayXd::Ones(frf.H.size());
  }
  return 1.0 / relative.max(1e-3 * relative.mean());
}

Calibration fitted(const FrfSet& set, std::size_t index, double mass_kg) {
  const Frf& frf = set.frfs[index];
  const double sign = frf.response.sign * frf.reference.sign;
  const Eigen::VectorXcd log = unwrapped_log(sign * mass_kg * frf.H);
  const Eigen::ArrayXd w = weights_of(frf);
  const Eigen::ArrayXd omega = set.s.imag().array();
  // Phase: p0 - omega tau, p0 a multiple of pi up to the fit's error.
  const double sum = w.sum();
  const double mean_omega = (w * omega).sum() / sum;
  const Eigen::ArrayXd phase = log.imag().array();
  const double mean_phase = (w * phase).sum() / sum;
  const double spread = (w * (omega - mean_omega).square()).sum();
  Calibration result;
  result.frf = index;
  if (spread > 0.0) {
    result.delay_s =
        -(w * (omega - mean_omega) * (phase - mean_phase)).sum() / spread;
  }
  const double at_zero = mean_phase + mean_omega * result.delay_s;
  const bool turned = std::cos(at_zero) < 0.0;
  // |A m| = g exp(-sigma tau): the delay's share is taken out again.
  const double level =
      (w * (log.real().array() + set.s.real().array() * result.delay_s)).sum() /
      sum;
  result.gain = (turned ? -1.0 : 1.0) * std::exp(level);
  const Eigen::ArrayXcd model =
      result.gain * (-set.s.array() * result.delay_s).exp();
  const Eigen::ArrayXd d2 =
      ((sign * mass_kg * frf.H.array()) / model - 1.0).abs2();
  result.deviation = std::sqrt((w * d2).sum() / sum);
  const double free = std::max(1.0, sum * sum / w.square().sum() - 2.0);
  result.gain_sd =
      std::abs(result.gain) * result.deviation / std::sqrt(2 * free);
  result.delay_sd =
      spread > 0.0 ? result.deviation * std::sqrt(sum / (2.0 * free * spread))
                   : 0.0;
  return result;
}

}  // namespace

std::vector<Calibration> calibrate(const FrfSet& set, double mass_kg) {
  if (!(mass_kg > 0.0) || !std::isfinite(mass_kg)) {
    throw InputError(fmt::format("{} kg is no mass", mass_kg),
                     "calibration",
                     "give the mass of the body, sensors and fixings included");
  }
  std::vector<Calibration> result;
  for (std::size_t i = 0; i < set.frfs.size(); ++i) {
    const Frf& frf = set.frfs[i];
    if (frf.H.size() < 2 || !(frf.H.cwiseAbs().minCoeff() > 0.0)) continue;
    result.push_back(fitted(set, i, mass_kg));
  }
  return result;
}

}  // namespace tapfit::signal
