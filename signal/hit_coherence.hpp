// How well every two hits of a run agree, and which stand apart.
//
//   g_ij^2 = |Y_i F_i* + Y_j F_j*|^2 / ((|F_i|^2 + |F_j|^2)(|Y_i|^2 + |Y_j|^2))
//
// is the coherence of two hits, averaged over the lines. A row of low values
// in sensors x hits is a bad sensor, a column a bad hit.
#pragma once

#include "signal/estimate_frfs.hpp"
#include "signal/spectra.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::signal {

struct HitCoherence {
  std::vector<std::size_t> hits;       ///< accepted ones, index into the run's
  std::vector<Eigen::MatrixXd> pairs;  ///< per sensor, hits x hits, 0..1
  Eigen::MatrixXd with_others;         ///< sensors x hits, mean over the others
};

/// @param spectra of the hits, one column each
[[nodiscard]] HitCoherence hit_coherence(const Spectra& spectra);

/// Of a run's accepted hits. Fewer than two give empty matrices.
///
/// @param run index into the bundle's runs
/// @throws InputError as estimate_frfs
[[nodiscard]] HitCoherence run_coherence(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    std::size_t run);

/// Hits whose incoherence 1 - g^2 with the others (mean over sensors, median
/// over the others) is more than half a per cent and five times what the others
/// have among themselves. The worst goes first, then it is looked again; two
/// hits always remain.
///
/// @return indices into the run's hits, in order
[[nodiscard]] std::vector<std::size_t> hits_apart(const HitCoherence& of);

}  // namespace tapfit::signal
