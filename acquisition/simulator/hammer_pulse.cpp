#include "acquisition/simulator/hammer_pulse.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::acquisition {

std::vector<HammerPulse> ordinary_hits(const HammerHand& hand,
                                       SeededRandom& random) {
  std::vector<HammerPulse> pulses;
  for (int hit = 0; hit < hand.hits; ++hit) {
    HammerPulse pulse;
    pulse.begin_s =
        hand.lead_s + hand.gap_s * hit + hand.gap_s * random.uniform(0.0, 0.02);
    pulse.peak_n = hand.peak_n * random.scatter(hand.strength_scatter);
    // A harder hit presses the tip further, where it is stiffer: shorter.
    pulse.width_s = hand.width_s * random.scatter(hand.width_scatter) *
                    std::pow(pulse.peak_n / hand.peak_n, -0.15);
    pulse.skew = random.uniform(0.88, 1.0);
    pulses.push_back(pulse);
  }
  return pulses;
}

HammerPulse rebound(const HammerPulse& first, SeededRandom& random) {
  HammerPulse second = first;
  second.begin_s += first.width_s * random.uniform(5.0, 9.0);
  second.width_s *= random.uniform(1.0, 1.2);
  second.peak_n *= random.uniform(0.25, 0.45);
  return second;
}

double duration(const HammerHand& hand) {
  return hand.lead_s + hand.gap_s * hand.hits;
}

Eigen::VectorXd force_of(const std::vector<HammerPulse>& pulses,
                         Eigen::Index samples,
                         double rate_hz) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(samples);
  for (const HammerPulse& pulse : pulses) {
    const auto first =
        static_cast<Eigen::Index>(std::ceil(pulse.begin_s * rate_hz));
    for (Eigen::Index n = std::max<Eigen::Index>(first, 0); n < samples; ++n) {
      const double u =
          (static_cast<double>(n) / rate_hz - pulse.begin_s) / pulse.width_s;
      if (u >= 1.0) break;
      const double shape = std::sin(std::numbers::pi * std::pow(u, pulse.skew));
      force(n) += pulse.peak_n * std::pow(std::max(shape, 0.0), 1.5);
    }
  }
  return force;
}

}  // namespace tapfit::acquisition
