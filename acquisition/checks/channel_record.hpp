// The room acquisition/checks. What the records give away by themselves, before
// any FRF: resolution, range, dropouts, drift, channels without a signal or
// exchanged, records that are the same or run backwards, runs without a good
// hit.
// In:  A test bundle, its recordings and hits.
// Out: Findings, and a table of what each channel recorded. Nothing is changed.
// May include: its row in CONTRIBUTING.md.
//
// What a channel recorded in one run, in numbers.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/hits/hits.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::acquisition {

/// One channel of one run.
struct ChannelRecord {
  std::size_t run = 0;
  std::size_t channel = 0;
  double full_scale = 0.0;  ///< magnitude of a sample of 1.0 [SI]
  double peak = 0.0;        ///< largest distance from the baseline [SI]
  double level = 0.0;       ///< rms over the blocks of all hits [SI]
  double noise = 0.0;       ///< sd from sample to sample where quiet [SI]
  double step = 0.0;        ///< least change of value: the quantum [SI]
  double drift = 0.0;       ///< rms change of the mean from hit to hit [SI]
  int dropouts = 0;         ///< stretches in which the value stands still
  double first_dropout_s = 0.0;

  /// Bits that the record fills, of those that the converter has.
  [[nodiscard]] double bits() const;
  /// Share of full scale that is used.
  [[nodiscard]] double range_used() const { return peak / full_scale; }
};

/// The channels that a run uses, the hammer first.
///
/// A stretch of 9 equal samples or more is a dropout where the signal beside
/// it changes by 4 quanta or more (rms) from sample to sample, and it does not
/// stand at the channel's extreme (that is clipping). A pair of neighbours is
/// then equal by chance in less than one of ten, 9 in a row in one of 1e9; a
/// smooth peak with that slope beside it has 6 equal ones at the most.
///
/// @param hits of the run, whatever was thought of them; may be empty
/// @param block [samples]
[[nodiscard]] std::vector<ChannelRecord> channel_records(
    const TestBundle& bundle,
    std::size_t run,
    const Recording& recording,
    const std::vector<Hit>& hits,
    Eigen::Index block);

/// Of all runs that have samples, one after the other.
[[nodiscard]] std::vector<ChannelRecord> channel_records(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits);

}  // namespace tapfit::acquisition
