// The running average of one run or of several of the same placement: hits go
// in, FRFs come out at any time.
#pragma once

#include "signal/estimate/estimator.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "signal/spectra/line_noise.hpp"
#include "signal/spectra/spectra.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::signal {

/// What is kept of the hits so far: its size does not grow with their number.
struct RunAverage {
  Eigen::VectorXcd s;               ///< lines [rad/s]
  std::vector<CrossPowers> powers;  ///< per sensor
  std::vector<LineNoise> noise;     ///< per sensor, mean over hits

  [[nodiscard]] Eigen::Index hits() const {
    return powers.empty() ? 0 : powers[0].hits;
  }
};

/// Adds the hits of another run of the same placement, on the same lines.
void add_hits(const RunAverage& more, RunAverage& average);

/// Adds the hits of some blocks of the run.
///
/// @param spectra of the blocks, on the average's lines
void add_hits(const HitBlocks& blocks,
              const Spectra& spectra,
              RunAverage& average);

/// The FRFs of the hits so far, with coherence and variance.
///
/// @param run index into the bundle's runs, the first of its like; velocity and
/// displacement become
///   accelerances
/// @return one per sensor; none without hits
[[nodiscard]] std::vector<Frf> average_frfs(
    const RunAverage& average,
    const acquisition::TestBundle& bundle,
    std::size_t run,
    Estimator estimator);

}  // namespace tapfit::signal
