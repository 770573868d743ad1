// Tones that stand in a record before the first blow: mains hum, a machine next
// door. Of the quiet stretch, with the mean and slope taken off,
//
//   x_n = a cos(w n) + b sin(w n) + e_n,
//
// w where the periodogram is largest. Of noise the largest of m lines holds the
// share g of all their power, or more, with a probability of about
// m (1 - g)^(m-1). What still rings from an earlier blow decays: a tone is as
// strong in the second half of the stretch as in the first.
//
// Source: R. A. Fisher, "Tests of significance in harmonic analysis", Proc. R.
// Soc. A 125, 1929.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hits.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace tapfit::acquisition {

struct Tone {
  double hz = 0.0;
  double rms = 0.0;            ///< [of the samples]
  double resolution_hz = 0.0;  ///< of the stretch: one over its length
};

struct ToneLimits {
  Eigen::Index most_samples = 4096;  ///< looked at; means of more
  double false_alarm = 1e-9;         ///< of one stretch
  double fewest_periods = 4.0;       ///< less is drift
  double steady = 0.25;              ///< change from half to half
  /// Of the response's rms: the 400th part of its power, as a weak mode has.
  double worth_saying = 0.05;
};

/// The strongest steady tone of a stretch of samples, if there is one.
[[nodiscard]] std::optional<Tone> steady_tone(
    const Eigen::Ref<const Eigen::VectorXd>& x,
    double rate_hz,
    const ToneLimits& limits = {});

/// Of sensors, one finding for each tone and the runs that share it.
[[nodiscard]] std::vector<Finding> tone_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits,
    const ToneLimits& limits = {});

}  // namespace tapfit::acquisition
