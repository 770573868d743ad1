// Hits of a run that comes in piece by piece: found, judged and given out as
// soon as their block is complete.
//
// What a trial look at the record has chosen (level, block, hold-off) stays as
// it is from then on, as on an analyser. Each hit is judged with the same steps
// as in a record that is there as a whole; weak and outlier against those that
// were accepted before it.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/hits/hit_steps.hpp"

#include <vector>

namespace tapfit::acquisition {

/// What stays fixed while a run is replayed.
struct LiveSettings {
  HitSet set;                ///< rate, block, pre-trigger, hold-off, level
  std::optional<int> slope;  ///< which way blows go in this run
  double rearm = 0.5;        ///< share of the level
  double double_hit_percent = 5.0;
  /// At which hits are cut off ahead of the recorder, as the trial look found.
  std::optional<HammerSaturation> ceiling;
};

/// What is remembered of the hits so far; of the last 256 accepted ones.
struct LiveHits {
  Eigen::Index last_trigger = -1;  ///< from the file's start; -1: none
  std::vector<double> peaks;       ///< of the run's accepted ones [N]
  /// response_per_impulse of the accepted ones of this run and of earlier ones
  /// of the same placement.
  std::vector<Eigen::VectorXd> levels;
};

/// Another run of the same placement begins.
void begin_run(LiveHits& known);

/// A piece of a run, and which of its hits are to be given out.
struct LivePiece {
  Recording recording;
  Eigen::Index start = 0;      ///< its first sample, from the file's start
  Eigen::Index own_begin = 0;  ///< triggers from here on are new ...
  Eigen::Index own_end = 0;    ///< ... up to here (rows of the piece)
};

/// All hits that the piece knows of, earlier and later ones too, with `begin`
/// and `trigger` as rows of the piece and `time_s` from the file's start. Only
/// new ones can be accepted.
struct FoundHits {
  std::vector<Hit> hits;
  std::vector<bool> is_new;  ///< per hit
};

/// @param known is brought up to date
[[nodiscard]] FoundHits find_live_hits(const TestBundle& bundle,
                                       const Run& run,
                                       const LivePiece& piece,
                                       const LiveSettings& settings,
                                       LiveHits& known);

}  // namespace tapfit::acquisition
