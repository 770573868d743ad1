// Whether the hammer's channel holds the blows, and whether they are as short
// as blows are. A blow is over in milliseconds; a response rings on.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hits.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Samples that hold a channel's energy: (sum x^2)^2 / sum x^4 of what stands
/// 6 times out of the noise, from the median; 0 where its peak is not ten
/// times that, so that it is not seen to fall.
///
/// Pulses of one shape count as often as there are, each by its own width.
[[nodiscard]] double effective_samples(
    const Eigen::Ref<const Eigen::VectorXd>& channel);

/// Runs in which another channel holds the blows (with its name), and blows
/// that last as long as no blow does, as where times in ms were read as s.
[[nodiscard]] std::vector<Finding> force_channel_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

}  // namespace tapfit::acquisition
