// What speaks against a channel's records as such: too coarse a converter, too
// small a part of the range, samples that stand still, a wandering zero.
#pragma once

#include "acquisition/checks/channel_record.hpp"
#include "acquisition/foundation/finding.hpp"

#include <vector>

namespace tapfit::acquisition {

/// One finding per channel and fault, with all runs that show it.
[[nodiscard]] std::vector<Finding> record_findings(
    const TestBundle& bundle, const std::vector<ChannelRecord>& records);

}  // namespace tapfit::acquisition
