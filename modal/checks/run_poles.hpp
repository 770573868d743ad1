// Each run's poles against those of the other runs: a run of another structure
// has its own, and a structure that warms up or works loose moves them.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <vector>

namespace tapfit::modal {

struct RunPoleLimits {
  std::size_t fewest_runs = 4;  ///< for "the others" to mean something
  /// A pole is the structure's where so large a share of the other runs (and
  /// two at the least) show a peak of it, this high against the FRF's rms.
  double shown_by = 0.4;
  double shown = 0.3;
  /// Of a run that is left by the others' poles (rms), and times their median:
  /// what is left of another structure is nearly all of it.
  double foreign = 0.4;
  double foreign_times = 5.0;
  /// Standard deviations, stated or as the runs scatter, whichever is more.
  double significance = 6.0;
  /// Of frequency, in damping ratios: a fifth of the half bandwidth is a fifth
  /// of the FRF beside the peak.
  double worth_saying = 0.2;
};

/// Runs that do not belong to the others, and frequencies that move from run to
/// run while all sensors stay.
[[nodiscard]] std::vector<Finding> run_pole_findings(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& set,
    const ModeSet& modes,
    const RunPoleLimits& limits = {});

/// The poles of a set's modes [rad/s], Im > 0.
[[nodiscard]] Eigen::VectorXcd poles_of(const ModeSet& modes);

/// Poles that lie within each other's half-power bandwidths, as indices: close
/// modes, or one mode that runs disagree on. Single ones are groups, too.
[[nodiscard]] std::vector<std::vector<Eigen::Index>> pole_groups(
    const Eigen::VectorXcd& poles);

}  // namespace tapfit::modal
