// The room acquisition/hits. Hits: triggered, cut into blocks of one length,
// and judged.
// In:  A test bundle and its recordings.
// Out: HitSet: per run the hits, each accepted or with what speaks against it;
//      what was chosen and what is odd, in words. A run can also come in piece
//      by piece (live_hits.hpp).
// May include: its row in CONTRIBUTING.md.
//
// Finds the hits in the hammer channel, and judges them.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/hits/hits.hpp"

#include <vector>

namespace tapfit::acquisition {

/// Finds and judges the hits of all runs.
///
/// The block is as long as the gaps between hits allow (and no longer than the
/// response lasts), the same for all hits. The bundle's band says how soft a
/// hit may be (without one: see usable_bandwidth()). Empty options are taken
/// from the bundle, else chosen and stated. Outliers are judged among all hits
/// of one placement (runs_alike.hpp); where all of these are judged out, each
/// run keeps its best one when that is merely weak, soft or an outlier.
///
/// @throws InputError when a run holds no hit at all
[[nodiscard]] HitSet find_hits(const TestBundle& bundle,
                               const std::vector<Recording>& recordings,
                               const HitOptions& given);

}  // namespace tapfit::acquisition
