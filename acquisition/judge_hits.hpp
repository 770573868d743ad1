// What speaks against a hit, one question each.
#pragma once

#include "acquisition/hammer_pulses.hpp"

#include <Eigen/Core>

namespace tapfit::acquisition {

/// Whether a second blow follows (or precedes) the main pulse in the block.
///
/// It must reach `percent` of the main pulse, stand 6.5 times out of the noise
/// and clearly out of what swings below zero around it: the ringing of an
/// anti-alias filter, hum and vibration are as large below zero as above, a
/// blow is not.
///
/// @param force drift-free, blows positive [N]
/// @param begin, end samples of the block
[[nodiscard]] bool has_second_pulse(const HammerSignal& hammer,
                                    const Pulse& main,
                                    Eigen::Index begin,
                                    Eigen::Index end,
                                    double percent);

/// Force spectrum at the band's end against its low end [dB], by a direct
/// Fourier sum over the main pulse; 0 = as strong as at zero frequency.
///
/// The largest of the last tenth of the band is taken, so that a zero of the
/// pulse's spectrum which happens to lie on the end is not decisive.
[[nodiscard]] double force_level_db(const HammerSignal& hammer,
                                    const Pulse& main,
                                    double band_end_hz,
                                    double sample_rate_hz);

/// Whether a channel was overdriven in a block: it reaches 99.9 % of the
/// declared full scale, or its top is flat in a way that no smooth peak is.
///
/// A flat top is a run of n >= 3 samples within a tolerance d of the extreme,
/// with the signal more than 10 d below it half a run further on both sides;
/// a parabola falls at most 6 d there. d covers noise after the clipping (8
/// standard deviations), a quantisation step and 1e-5 of the swing.
///
/// @param block the channel's samples in the block, offset and all
/// @param full_scale of the channel, > 0, in the block's unit
/// @param noise standard deviation of sample-to-sample noise
[[nodiscard]] bool is_overloaded(const Eigen::Ref<const Eigen::VectorXd>& block,
                                 double full_scale,
                                 double noise);

/// Sample-to-sample noise of a channel: robust standard deviation of its first
/// differences over sqrt(2), from the quietest of 16 parts (of 4096 to 8191
/// pairs of neighbours of each).
[[nodiscard]] double difference_noise(
    const Eigen::Ref<const Eigen::VectorXd>& channel);

}  // namespace tapfit::acquisition
