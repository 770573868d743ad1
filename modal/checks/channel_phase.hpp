// The phase of each channel's modal constants. Of an accelerance they are real,
// whichever the two points. A channel that lags by tau turns each mode by
// -w tau, one that measures velocity turns all of them by 90 degrees:
//
//   arg z_ck = theta_0 - w_k tau  (mod 180 degrees),  theta_0 = 0 or 90
//
// One behind a filter of first order is turned by atan(w_c / w_k) where this
// passes what is high, by -atan(w_k / w_c) where it passes what is low.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tapfit::modal {

/// Of first order.
struct PhaseFilter {
  bool high_pass = false;
  double corner_hz = 0.0;
  double corner_sd_hz = 0.0;
  double turn = 0.0;  ///< the most that it turns any of the modes by [rad]
  double left = 0.0;  ///< mean of sin^2 of what it leaves
};

struct ChannelPhase {
  std::size_t channel = 0;
  double turned = 0.0;   ///< mean of sin^2 of the phase: 0 real, 1 imaginary
  double delay_s = 0.0;  ///< tau that fits best; 0 with fewer than 3 modes
  double delay_sd = 0.0;
  double with_delay = 0.0;  ///< mean of sin^2 of what the delay leaves
  /// The filter that fits best; none with fewer than 3 modes.
  std::optional<PhaseFilter> filter = {};
};

struct ChannelPhaseLimits {
  Eigen::Index fewest_modes = 3;  ///< one number must explain two others
  double slight_phase = 0.05;     ///< of a delay at the highest mode [rad]
  double significance = 5.0;      ///< standard deviations of the delay
  double explained = 0.2;         ///< share of sin^2 that it may leave
  double imaginary = 0.9;         ///< mean sin^2 from which on it is a velocity
  /// What a filter leaves against a delay: below its corner they do alike.
  double rather_filter = 0.5;
};

/// In the order of the channels; those of few or weak modes are left out.
[[nodiscard]] std::vector<ChannelPhase> channel_phases(
    const signal::FrfSet& set,
    const ModeSet& modes,
    const ChannelPhaseLimits& limits = {});

/// Delays against the hammer, filters, and channels that measure velocity.
[[nodiscard]] std::vector<Finding> channel_phase_findings(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& set,
    const ModeSet& modes,
    const ChannelPhaseLimits& limits = {});

}  // namespace tapfit::modal
