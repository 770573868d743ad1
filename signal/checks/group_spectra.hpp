// The hits of one placement, whichever runs they were recorded in, side by
// side: what checks from hit to hit start from.
#pragma once

#include "acquisition/bundle/runs_alike.hpp"
#include "acquisition/hits/hits.hpp"
#include "signal/spectra/line_noise.hpp"
#include "signal/spectra/spectra.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace tapfit::signal {

/// One hit of a bundle.
struct HitAt {
  std::size_t run = 0;  ///< index into the bundle's runs
  std::size_t hit = 0;  ///< index into the run's hits

  auto operator<=>(const HitAt&) const = default;
};

struct GroupSpectra {
  std::vector<HitAt> hits;            ///< accepted ones, in order
  std::vector<std::size_t> channels;  ///< of the sensors
  Eigen::VectorXcd s;                 ///< lines [rad/s]
  Spectra spectra;                    ///< one column for each of `hits`
  /// Per run of the group that has accepted hits, and per sensor.
  std::vector<std::vector<LineNoise>> noise;
  std::vector<std::size_t> noise_of;  ///< per hit an index into `noise`
};

/// Of the accepted hits of runs of one placement, whose hits are averaged
/// together; nothing but sensors and lines where there is none.
///
/// @param group of acquisition::runs_alike(), not empty
/// @throws InputError as estimate_frfs
[[nodiscard]] GroupSpectra group_spectra(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const acquisition::RunGroup& group);

}  // namespace tapfit::signal
