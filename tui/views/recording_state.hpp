// What the screen of recordings is drawn from, and what is chosen on it.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hits.hpp"
#include "acquisition/hits/readable_recordings.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/widgets/table.hpp"
#include "tui/widgets/trace.hpp"
#include "tui/workbench/run_look.hpp"

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace tapfit::tui {

struct RecordingInput {
  const acquisition::TestBundle& bundle;
  const std::vector<Trace>& traces;
  const acquisition::HitSet& hits;
  const RunLook* look = nullptr;  ///< of the run on show, once it is there
  const std::vector<acquisition::LeftOut>* left_out = nullptr;

  /// What is wrong with the test, once it is known.
  const std::vector<Finding>* findings = nullptr;
  const signal::FrfSet* frfs = nullptr;  ///< once they are known

  /// Why that run is left out, if it is.
  [[nodiscard]] const acquisition::LeftOut* not_used(std::size_t run) const;
};

/// A run played: what lies behind `time_s` has not been measured yet.
struct Playing {
  bool on = false;
  bool paused = false;
  double time_s = 0.0;
  double speed = 10.0;  ///< seconds of the recording per second
};

struct RecordingState {
  using HitAt = std::pair<std::size_t, std::size_t>;  ///< run, hit

  std::size_t run = 0;
  std::size_t sensor = 0;  ///< which of the run's sensors is drawn first
  ListState list;          ///< the run's hits
  PlotRange range;         ///< [s]
  int zoom = 0;  ///< 0 as the range says, 1 the hit's pulse, 2 its block
  std::set<HitAt> tagged;
  bool statements = false;  ///< what was chosen, instead of the plots
  bool findings = false;    ///< what is wrong with the test, likewise
  std::size_t finding = 0;  ///< the one at the top
  Playing playing;
  bool overview = false;  ///< all runs in place of the one on show
  ListState runs;         ///< of the overview
};

/// A row for each run: file, place of the hammer, hits, the coherence of its
/// worst FRF once FRFs are known, what there is to say of its hits.
[[nodiscard]] Table run_table(const RecordingInput& input);

/// Hits of the run on show that have been measured when the replay is at
/// `time_s`: whose block is complete.
[[nodiscard]] std::size_t hits_by(const RecordingInput& input,
                                  std::size_t run,
                                  double time_s);

}  // namespace tapfit::tui
