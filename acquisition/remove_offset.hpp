// Takes DC and slow drift off a channel.
#pragma once

#include "acquisition/range.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::acquisition {

/// The DC value just before a hit: the mean of the pre-trigger samples, and the
/// median of the whole channel where there is no pre-trigger.
///
/// @param channel the whole record of one channel
/// @param begin first sample of the block
/// @param pre_trigger samples of the block before the trigger
[[nodiscard]] double baseline(const Eigen::VectorXd& channel,
                              Eigen::Index begin,
                              Eigen::Index pre_trigger);

/// Median; 0 for no values. Takes a copy, because it reorders.
[[nodiscard]] double median(Eigen::VectorXd values);

/// At most `most` of the values, from the whole length: one out of each of as
/// many equal parts, at a place that differs from part to part, so that no hum
/// is in step with them.
[[nodiscard]] Eigen::VectorXd thinned(
    const Eigen::Ref<const Eigen::VectorXd>& values, Eigen::Index most);

struct Driftless {
  Eigen::VectorXd values;
  std::vector<Range> pieces;  ///< their ranges, as of piece_ranges()
};

/// A copy without its drift: medians of segments, joined by straight lines.
/// A segment's median is taken from 512 of its samples at most; it is then
/// known to 6 % of the noise.
///
/// A median does not see a hammer's pulse, which fills far less than half of
/// a segment; a response that rings at more than a few times 1/segment has a
/// median near its mean.
///
/// @param segment samples per segment, > 0
[[nodiscard]] Driftless without_drift(
    const Eigen::Ref<const Eigen::VectorXd>& channel, Eigen::Index segment);

}  // namespace tapfit::acquisition
