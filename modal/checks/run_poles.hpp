// Each run's poles against those of the other runs: a run of another structure
// has its own, and a structure that warms up or works loose moves them.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::modal {

struct RunPoleLimits {
  std::size_t fewest_runs = 4;  ///< for "the others" to mean something
  /// A pole is the structure's where so large a share of the other runs (and
  /// two at the least) show it out of its uncertainty, however low.
  double shown_by = 0.4;
  /// A peak says where it is from this height on, against the FRF's rms.
  double shown = 0.3;
  /// Of a run that is left by the others' poles (rms), and times their median:
  /// what is left of another structure is nearly all of it.
  double foreign = 0.4;
  double foreign_times = 5.0;
  /// Standard deviations, as the runs scatter.
  double significance = 6.0;
  /// Of frequency, in damping ratios: a fifth of the half bandwidth is a fifth
  /// of the FRF beside the peak.
  double worth_saying = 0.2;
};

/// A run whose FRFs the poles of the other runs do not explain.
struct ForeignRun {
  std::size_t run = 0;
  double left = 0.0;   ///< of its FRFs, relative (rms)
  double usual = 0.0;  ///< median over the runs
};

/// Runs of another structure.
/// @return none with fewer runs than `fewest_runs`, or without modes
[[nodiscard]] std::vector<ForeignRun> foreign_runs(
    const signal::FrfSet& set,
    const ModeSet& modes,
    const RunPoleLimits& limits = {});

/// "the resonances of the other runs leave 97 % of run 5 (run-5.wav), and 2 %
/// of the others".
[[nodiscard]] std::string statement(const ForeignRun& foreign,
                                    const acquisition::TestBundle& bundle);

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
