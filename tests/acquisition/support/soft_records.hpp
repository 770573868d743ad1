// Six ordinary blows of one tip, for how often one of them is called soft
// where no band says what is asked for. For tests and the study over seeds.
#pragma once

#include "acquisition/hits/find_hits.hpp"
#include "tests/acquisition/support/hammer_record.hpp"

#include <vector>

namespace tapfit::testing {

struct Tip {
  double rate = 0.0;
  double width_s = 0.0;        ///< foot to foot
  double power = 1.0;          ///< of the cosine: 1 half-sine, 2 Hann
  double width_scatter = 0.0;  ///< relative standard deviation
};

/// From blow to blow: deliberate ones are half a second apart or more, and the
/// shortest block has 200 lines up to 0.4 of the rate. The first comes after
/// 0.6 of it.
inline double gap_of(const Tip& tip) { return 0.6 + 1000.0 / tip.rate; }

/// The blows as an anti-alias filter lets them through, and a mode's answer;
/// noise of 1e-4 of each channel's largest value.
inline acquisition::Recording blows_of(const Tip& tip,
                                       std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal;
  constexpr int blows = 6;
  const double gap_s = gap_of(tip);
  const auto n = static_cast<Eigen::Index>((blows + 0.6) * gap_s * tip.rate);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd response = Eigen::VectorXd::Zero(n);
  for (int k = 0; k < blows; ++k) {
    const double time_s = (0.6 + k) * gap_s + uniform(random) / tip.rate;
    const double width_s =
        tip.width_s * std::exp(tip.width_scatter * normal(random));
    const double peak = 20.0 + k;
    add_pulse(force,
              tip.rate,
              time_s,
              width_s,
              peak,
              width_s * tip.rate < 20.0,
              tip.power);
    add_response(
        response, tip.rate, time_s, 0.05 * tip.rate, 10.0 / gap_s, peak);
  }
  add_noise(force, 1e-4 * force.maxCoeff(), random);
  add_noise(response, 1e-4 * response.maxCoeff(), random);
  acquisition::Recording recording;
  recording.sample_rate_hz = tip.rate;
  recording.samples.resize(n, 2);
  recording.samples << force, response;
  return recording;
}

/// Hits found without a band.
inline acquisition::HitSet hits_of(const Tip& tip, std::mt19937_64& random) {
  return acquisition::find_hits(hammer_bundle(), {blows_of(tip, random)}, {});
}

inline int judged_soft(const acquisition::HitSet& hits) {
  int soft = 0;
  for (const acquisition::Hit& hit : hits.runs.at(0)) {
    soft += static_cast<int>(std::count(
        hit.reasons.begin(), hit.reasons.end(), acquisition::HitFault::Soft));
  }
  return soft;
}

}  // namespace tapfit::testing
