// What sensors hear before and after each blow. A structure answers afterwards:
// a record that is louder before its blows runs backwards, a channel that is as
// loud before as after hears nothing of them.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hits.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::acquisition {

/// A sensor's mean power after one blow over that before it.
struct BlowResponse {
  std::size_t run = 0;
  std::size_t channel = 0;
  std::size_t hit = 0;
  double gain = 1.0;
};

/// Both windows are of one length: a quarter of the block, or as far as the
/// file or half the way to the hits beside it allows; not less than 16 samples.
/// The pulse itself lies in neither.
[[nodiscard]] std::vector<BlowResponse> blow_responses(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

struct BlowResponseLimits {
  /// Louder before the blow by this in power (median of the run), on as large a
  /// share of sensors and hits: a decay cannot.
  double backwards = 0.5;
  double backwards_share = 0.8;
  /// Power of noise alone over a window of n >= 16 samples scatters by
  /// sqrt(4 / n) <= 0.5; the median of several is nearer to 1.
  double silent = 1.5;
  /// What it should hear for silence to mean something (6 dB), by what the
  /// others hear and what it hears of other blows: near a clamp and hit there,
  /// nobody hears much.
  double heard = 4.0;
};

/// Runs whose time runs backwards, channels that are silent in some or all
/// runs.
[[nodiscard]] std::vector<Finding> blow_response_findings(
    const TestBundle& bundle,
    const std::vector<BlowResponse>& responses,
    const BlowResponseLimits& limits = {});

}  // namespace tapfit::acquisition
