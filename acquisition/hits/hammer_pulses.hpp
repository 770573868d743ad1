// Pulses of the hammer: the force channel made ready for triggering, and the
// places where it rises over a level.
#pragma once

#include "acquisition/samples/baseline_removal.hpp"
#include "acquisition/samples/range.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::acquisition {

/// The force channel with drift removed and turned so that a blow is positive.
/// It looks at the channel, which must outlive it.
struct HammerSignal {
  BaselineFree force;     ///< [N]
  double noise = 0.0;     ///< robust standard deviation (1.4826 MAD), > 0 [N]
  double polarity = 1.0;  ///< -1 when blows are negative in the file
  double peak = 0.0;      ///< largest value [N]
  /// Bounds of `force` by pieces, as of BaselineFree::pieces().
  std::vector<Range> pieces;
};

/// @param channel force as read [N]
/// @param sample_rate_hz > 0
/// @param polarity 1 or -1 where it is known; empty: the larger side
[[nodiscard]] HammerSignal prepare_hammer(
    const Eigen::Ref<const Eigen::VectorXd>& channel,
    double sample_rate_hz,
    std::optional<int> polarity = std::nullopt);

struct Pulse {
  Eigen::Index first = 0;  ///< where the level was crossed upwards
  Eigen::Index peak = 0;   ///< sample of the largest value
  double centre = 0.0;     ///< of the interpolated peak [samples]
  double height = 0.0;     ///< of the interpolated peak [N]
  double width = 0.0;      ///< between the 10 % points [samples]
};

/// All pulses over the level, in time order.
///
/// The trigger is armed again once the force has stayed below a share of the
/// level for four samples or half a pulse width, whichever is longer: an
/// anti-alias filter's ringing swings within two or three samples.
///
/// @param pieces bounds of the force, as of BaselineFree::pieces()
/// @param rearm that share, 0..1
[[nodiscard]] std::vector<Pulse> find_pulses(const BaselineFree& force,
                                             const std::vector<Range>& pieces,
                                             double level,
                                             double rearm = 0.5);

/// Measures the pulse whose highest sample is given; `first` is left at it.
[[nodiscard]] Pulse measure_pulse(const BaselineFree& force, Eigen::Index peak);

}  // namespace tapfit::acquisition
