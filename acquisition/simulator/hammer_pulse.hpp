// The force of a hand that holds an instrumented hammer.
//
//   f(t) = peak sin(pi u^skew)^1.5,   u = (t - begin) / width,  0 <= u <= 1
//
// between a half-sine (a tip as a linear spring) and sin^2: a rubber or
// plastic tip stiffens while it is pressed. Width, strength and skew vary from
// hit to hit.
#pragma once

#include "acquisition/foundation/seeded_random.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::acquisition {

struct HammerPulse {
  double begin_s = 0.0;
  double width_s = 0.0;  ///< foot to foot
  double peak_n = 0.0;
  double skew = 1.0;  ///< below 1: rises faster than it falls
};

struct HammerHand {
  int hits = 5;
  double lead_s = 1.0;            ///< before the first hit
  double gap_s = 18.0;            ///< between hits, and after the last one
  double peak_n = 20.0;           ///< of a middling hit
  double width_s = 0.009;         ///< of a middling hit
  double strength_scatter = 0.2;  ///< standard deviation of ln(peak)
  double width_scatter = 0.08;
};

/// An ordinary series of hits; the times wander by up to 2 % of the gap.
[[nodiscard]] std::vector<HammerPulse> ordinary_hits(const HammerHand& hand,
                                                     SeededRandom& random);

/// The pulse with which a slow hand touches the structure a second time.
[[nodiscard]] HammerPulse rebound(const HammerPulse& first,
                                  SeededRandom& random);

/// How long a recording of these hits is [s].
[[nodiscard]] double duration(const HammerHand& hand);

/// The force over time [N], n samples from t = 0.
[[nodiscard]] Eigen::VectorXd force_of(const std::vector<HammerPulse>& pulses,
                                       Eigen::Index samples,
                                       double rate_hz);

}  // namespace tapfit::acquisition
