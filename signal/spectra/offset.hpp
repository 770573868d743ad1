// The level a channel stood at when the hit came: offset, drift and slow swing.
//
//   offset = sum_n h_n x_n / sum_n h_n,   h a Hann window over a quiet stretch
//
// An offset that is left in becomes a step at the trigger, d/s in the
// transform, which drowns the low lines. A plain mean over a short pre-trigger
// keeps a part of hum and of an earlier, still ringing response. The Hann
// weights over some periods of the lowest frequency of interest take out all
// that is in the band, and follow what is slower.
#pragma once

#include <Eigen/Core>

namespace tapfit::signal {

/// Samples of a recording, [begin, end).
struct Stretch {
  Eigen::Index begin = 0;
  Eigen::Index end = 0;
  [[nodiscard]] Eigen::Index length() const { return end - begin; }
};

/// The quiet samples before a hit.
///
/// @param earlier sample of the earlier hit's trigger, 0 when there is none
/// @param onset sample at which this hit begins
/// @param wanted samples that suffice
[[nodiscard]] Stretch quiet_stretch(Eigen::Index earlier,
                                    Eigen::Index onset,
                                    Eigen::Index wanted);

/// Hann-weighted mean of the samples; 0 for none.
[[nodiscard]] double hann_mean(const Eigen::Ref<const Eigen::VectorXd>& x);

/// Hann weights, n of them, all above zero.
[[nodiscard]] Eigen::VectorXd hann(Eigen::Index n);

/// Level of one channel at a hit: from the stretch before it; where that is
/// shorter than half of what is wanted, joined (by length) with the mean over
/// the stretch after it, in which the response has to average out.
///
/// @param channel all samples of the channel
[[nodiscard]] double offset_at_hit(
    const Eigen::Ref<const Eigen::VectorXd>& channel,
    const Stretch& before,
    const Stretch& after,
    Eigen::Index wanted);

}  // namespace tapfit::signal
