// A test replayed as if it were being measured: samples come in piece by piece,
// a hit is judged and averaged when its block is complete, and then forgotten.
// Memory does not grow with the length of the recording.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/hits/hits.hpp"
#include "signal/estimate/estimate_frfs.hpp"

#include <functional>

namespace tapfit::signal {

struct ReplayOptions {
  FrfOptions frf;  ///< lasting_poles are not used
  acquisition::HitOptions hits;
  double speed = 0.0;  ///< seconds of recording per second; 0: no waiting
  /// Samples (all channels of all runs) that the trial look at the beginning
  /// may take.
  Eigen::Index trial_samples = 4 << 20;
  /// Samples (all channels) held at a time: 32 MB; more where a block needs it.
  Eigen::Index piece_samples = 4 << 20;
};

/// A hit as it comes.
struct LiveHit {
  std::size_t run = 0;
  const acquisition::Hit& hit;
  Eigen::Index averaged = 0;  ///< hits in its FRFs' average now
};

struct Replayed {
  acquisition::HitSet hits;  ///< settings and statements; hits of all runs
  FrfSet frfs;
};

/// Replays all runs, one after the other.
///
/// Level, block, pre-trigger and hold-off are chosen from the beginning of
/// every run, as far as trial_samples go, and stay. Sound files and universal
/// files are streamed alike. Where responses outlast the block, a longer one or
/// a narrower band is proposed first among the statements of the FRFs, as
/// estimate_frfs() does; of each run its strongest hit is looked at. Runs of
/// one placement are averaged together, as by estimate_frfs().
///
/// @param on_hit called for each hit as soon as its block is complete
/// @throws InputError as read_recording, find_hits and estimate_frfs
[[nodiscard]] Replayed replay(const acquisition::TestBundle& bundle,
                              const ReplayOptions& options,
                              const std::function<void(const LiveHit&)>& on_hit,
                              const Progress& progress = {});

}  // namespace tapfit::signal
