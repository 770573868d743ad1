// What speaks against a channel's records as such: too coarse a converter, too
// small a part of the range, samples that stand still, a wandering zero.
#pragma once

#include "acquisition/checks/channel_record.hpp"
#include "acquisition/foundation/finding.hpp"

#include <vector>

namespace tapfit::acquisition {

struct RecordLimits {
  /// A sensor's level over the quantisation noise (step / sqrt 12) [dB]. Below
  /// it quantisation is more than 1 % of the average line of an FRF, and more
  /// than all of it at an antiresonance 40 dB down.
  double least_over_quantum_db = 40.0;
  double least_hammer_bits = 7.0;  ///< a blow is then known to 1 %
  double least_range_used = 0.01;  ///< of full scale: 7 bits are given away
  /// The mean's change from block to block, of the level: a slope of that much
  /// within a block stands in the lowest lines with a third of it.
  double most_drift = 0.1;
};

/// One finding per channel and fault, with all runs that show it.
[[nodiscard]] std::vector<Finding> record_findings(
    const TestBundle& bundle,
    const std::vector<ChannelRecord>& records,
    const RecordLimits& limits = {});

}  // namespace tapfit::acquisition
