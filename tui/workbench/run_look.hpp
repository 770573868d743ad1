// A run looked at closely: the windows laid over each hit, how well the hits
// agree, and how the average grew with each of them. Hits of runs of the same
// placement are averaged together, so those of earlier ones come first.
#pragma once

#include "acquisition/hits/hits.hpp"
#include "signal/checks/hit_coherence.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::tui {

/// As signal/spectra/hit_blocks.hpp lays them over one hit.
struct HitWindow {
  double begin_s = 0.0;    ///< of the block, from the recording's start
  double trigger_s = 0.0;  ///< where the exponential window begins
  double end_s = 0.0;      ///< of the block
  double sigma = 0.0;      ///< of the exponential window [1/s]
  double pulse_s = 0.0;    ///< where the force window begins to open
  Eigen::VectorXd pulse;   ///< the force window's samples from there on, 0..1
  double step_s = 0.0;     ///< between them

  /// exp(-sigma t) within the block, 0 outside.
  [[nodiscard]] double exponential(double time_s) const;
};

struct RunLook {
  /// One per hit of the run; empty where a hit cannot be cut out.
  std::vector<std::optional<HitWindow>> windows;
  signal::RunCoherence coherence;
  /// FRFs of the run's sensors with its first accepted hit, the first two...
  std::vector<std::vector<signal::Frf>> averages;
  Eigen::VectorXcd s;  ///< their lines [rad/s]
};

/// @param run index into the bundle's runs
/// @throws InputError as signal::plan_frfs
[[nodiscard]] RunLook look_at_run(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    std::size_t run);

}  // namespace tapfit::tui
