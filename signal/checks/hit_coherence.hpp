// How well every two hits of one placement agree, and which stand apart.
//
//   g_ij^2 = |Y_i F_i* + Y_j F_j*|^2 / ((|F_i|^2 + |F_j|^2)(|Y_i|^2 + |Y_j|^2))
//
// is the coherence of two hits, averaged over the lines. A row of low values
// in sensors x hits is a bad sensor, a column a bad hit.
#pragma once

#include "acquisition/bundle/runs_alike.hpp"
#include "signal/checks/group_spectra.hpp"
#include "signal/spectra/spectra.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::signal {

struct HitCoherence {
  std::vector<HitAt> hits;             ///< accepted ones, in order
  std::vector<std::size_t> channels;   ///< of the sensors, where known
  std::vector<Eigen::MatrixXd> pairs;  ///< per sensor, hits x hits, 0..1
  Eigen::MatrixXd with_others;         ///< sensors x hits, mean over the others
};

/// @param spectra of the hits, one column each; taken as those of run 0
[[nodiscard]] HitCoherence hit_coherence(const Spectra& spectra);

/// Of the hits of one placement. Fewer than two give empty matrices.
[[nodiscard]] HitCoherence group_coherence(const GroupSpectra& of);

/// Of the accepted hits of runs of one placement, whose hits are averaged
/// together. Fewer than two give empty matrices.
///
/// @param group of acquisition::runs_alike()
/// @throws InputError as estimate_frfs
[[nodiscard]] HitCoherence group_coherence(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const acquisition::RunGroup& group);

/// One run's part: its hits, each with the others of the whole group.
struct RunCoherence {
  std::vector<std::size_t> hits;  ///< index into the run's
  Eigen::MatrixXd with_others;    ///< sensors x hits
};

/// @param of the run's group
/// @return sensors in the run's own order
[[nodiscard]] RunCoherence part_of(const HitCoherence& of,
                                   const acquisition::TestBundle& bundle,
                                   std::size_t run);

/// Hits whose incoherence 1 - g^2 with the others (mean over sensors, median
/// over the others) is more than half a per cent and five times what the others
/// have among themselves. The worst goes first, then it is looked again; two
/// hits always remain.
///
/// @return in order
[[nodiscard]] std::vector<HitAt> hits_apart(const HitCoherence& of);

}  // namespace tapfit::signal
