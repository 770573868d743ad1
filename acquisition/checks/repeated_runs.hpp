// What holds the same samples: a file that was listed or copied twice, a signal
// that was recorded on two channels.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Noise makes no two recordings alike, so all samples being equal is proof.
/// At one placement hits count twice; at two, one of the points is wrong.
///
/// @param recordings of all runs; those without samples are passed over
[[nodiscard]] std::vector<Finding> repeated_run_findings(
    const TestBundle& bundle, const std::vector<Recording>& recordings);

/// Two channels of a run that hold one signal, times a factor: they never
/// differ by more than two steps of their converters each, over a hundred and
/// more. One finding for all runs that two channels are alike in.
[[nodiscard]] std::vector<Finding> repeated_channel_findings(
    const TestBundle& bundle, const std::vector<Recording>& recordings);

}  // namespace tapfit::acquisition
