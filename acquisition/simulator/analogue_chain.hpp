// What a sensor, its cable and a recorder do to a signal.
//
//   v = gain x(t - delay) + noise + hum + offset + drift,
//   sample = round(clip(v / full scale))   to 24 bits
#pragma once

#include "acquisition/foundation/seeded_random.hpp"

#include <Eigen/Core>

namespace tapfit::acquisition {

/// One channel's faults, in the channel's own unit [SI].
struct AnalogueChannel {
  double full_scale = 1.0;  ///< value of digital full scale
  double gain = 1.0;        ///< true over stated sensitivity; < 0: polarity
  double noise_rms = 0.0;   ///< white over the recorded band
  double hum = 0.0;         ///< amplitude at the mains frequency
  double offset = 0.0;
  double drift = 0.0;  ///< how far the zero wanders within a minute
};

/// Mains frequency [Hz] and how its harmonics fall off: hum / order^2.
inline constexpr double mains_hz = 50.0;

/// Adds the chain's faults to one channel and converts it to samples.
///
/// @param signal what the sensor feels, filtered as by the recorder [SI]
/// @return samples in [-1, 1 - 2^-23], multiples of 2^-23
[[nodiscard]] Eigen::VectorXd pass_chain(const Eigen::VectorXd& signal,
                                         double rate_hz,
                                         const AnalogueChannel& channel,
                                         SeededRandom& random);

}  // namespace tapfit::acquisition
