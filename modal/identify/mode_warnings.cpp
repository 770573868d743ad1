#include "modal/identify/mode_warnings.hpp"

#include "acquisition/foundation/constants.hpp"
#include "modal/mode_set/complexity.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;

}  // namespace

void warn_about(const Mode& mode, std::vector<std::string>& warnings) {
  if (mode.damping_ratio < 3.0 * mode.damping_sd) {
    warnings.push_back(fmt::format(
        "mode at {:.4g} Hz: damping {:.2g} is not resolved (sd {:.1g}); a "
        "longer block would help",
        mode.frequency_hz,
        mode.damping_ratio,
        mode.damping_sd));
  }
  if (mode.mpc < in_phase_mpc && mode.shape.size() > 2) {
    warnings.push_back(fmt::format(
        "mode at {:.4g} Hz: points do not move in phase (MPC {:.2f})",
        mode.frequency_hz,
        mode.mpc));
  }
}

/// Without an exponential window the response has to die out in the block; it
/// is down to 0.2 % where the half-power bandwidth is two lines.
void warn_about_resolution(const WeightedFrfs& curves,
                           const Mode& mode,
                           std::vector<std::string>& warnings) {
  const double lines = -2.0 * mode.pole.real() / curves.spacing;
  if (curves.sigma > 0.0 || lines >= 2.0) return;
  warnings.push_back(fmt::format(
      "mode at {:.4g} Hz: its half-power bandwidth is {:.1f} lines, damping "
      "{:.2g} is hardly resolved and may be the block's; a longer block or an "
      "exponential window would help",
      mode.frequency_hz,
      lines,
      mode.damping_ratio));
}

void warn_about_misfit(double synthesis_error,
                       std::vector<std::string>& warnings) {
  if (synthesis_error < 0.5) return;
  warnings.push_back(fmt::format(
      "the modes do not explain the FRFs (synthesis error {:.0f} %): look at "
      "their phase, at the sign of their imaginary part and at the band",
      100.0 * synthesis_error));
}

void warn_about_complex(const std::vector<Complex>& poles,
                        const IdentifyOptions& options,
                        std::vector<std::string>& warnings) {
  for (const Complex& pole : poles) {
    warnings.push_back(fmt::format(
        "a pole at {:.4g} Hz was left out: its points do not move in phase "
        "(MPC below {:.2g} or MPD above {:.2g} deg)",
        std::abs(pole) / two_pi,
        options.least_mpc,
        options.largest_mpd_deg));
  }
}

void warn_about_shifting(const std::vector<Complex>& poles,
                         std::vector<std::string>& warnings) {
  for (const Complex& pole : poles) {
    warnings.push_back(fmt::format(
        "the pole at {:.5g} Hz is not quite the same in all FRFs (a sensor or "
        "hammer that moved, a level that changed), or two modes share it: a "
        "second reference tells",
        std::abs(pole) / two_pi));
  }
}

void warn_about_unresolved(const std::vector<Complex>& poles,
                           std::vector<std::string>& warnings) {
  for (const Complex& pole : poles) {
    warnings.push_back(fmt::format(
        "a pole at {:.4g} Hz was left out: its damping cannot be told from "
        "none (hum, or a block too short for it)",
        std::abs(pole) / two_pi));
  }
}

void warn_about_shared(const ModesOfPole& modes,
                       std::vector<std::string>& warnings) {
  const double hz = std::abs(modes.poles(0)) / two_pi;
  if (modes.poles.size() < modes.shapes) {
    warnings.push_back(fmt::format(
        "the pole at {:.5g} Hz holds {} shapes that cannot be taken apart; the "
        "one given is a mixture: measure the driving point of every reference",
        hz,
        modes.shapes));
  } else if (modes.shapes > 1 && modes.are_equal()) {
    warnings.push_back(fmt::format(
        "{} modes share the pole at {:.5g} Hz as far as the FRFs can tell: "
        "their shapes are one basis of many",
        modes.shapes,
        hz));
  }
}

}  // namespace tapfit::modal
