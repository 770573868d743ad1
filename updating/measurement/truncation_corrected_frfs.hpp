// FRFs of modes that outlast the block, freed of what that does to them.
//
// A mode that still rings when its block ends, or when the next hit comes, can
// be followed there with its pole, which is known only once the modes are:
// FRFs, modes, and FRFs again without the ringing of earlier hits and with the
// decay that the block's end cuts off, until the poles rest. Each time leaves
// about a tenth of what was wrong with them.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/hits/hits.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::updating {

struct TruncationCorrectedFrfs {
  signal::FrfSet set;
  Eigen::VectorXcd poles;  ///< of modes that outlast the block [rad/s]
  /// As identified from all lines of `set`, where that was done.
  std::optional<modal::ModeSet> modes;
};

/// H1 with the windows of signal::FrfOptions. Without TestBundle::band_hz
/// modes are followed up to HitSet::usable_bandwidth_hz; where none can be
/// identified, none is.
///
/// @throws InputError as of signal::estimate_frfs
[[nodiscard]] TruncationCorrectedFrfs estimate_truncation_corrected_frfs(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const Progress& progress);

}  // namespace tapfit::updating
