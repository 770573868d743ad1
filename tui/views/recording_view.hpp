// Screen 1: a run's channels against time, its hits and what is thought of
// each, how well they agree, and the average that they give; the run replayed
// as if it were being measured.
#pragma once

#include "tui/views/page.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/work/run_look.hpp"

#include <set>
#include <utility>

namespace tapfit::tui {

struct RecordingInput {
  const acquisition::TestBundle& bundle;
  const std::vector<Trace>& traces;
  const acquisition::HitSet& hits;
  const RunLook* look = nullptr;  ///< of the run on show, once it is there
  const std::vector<acquisition::LeftOut>* left_out = nullptr;

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
  Playing playing;
};

[[nodiscard]] Screen recording_view(const RecordingInput& input,
                                    const RecordingState& state,
                                    const Canvas& canvas);

/// Hits of the run on show that have been measured when the replay is at
/// `time_s`: whose block is complete.
[[nodiscard]] std::size_t hits_by(const RecordingInput& input,
                                  std::size_t run,
                                  double time_s);

class RecordingPage final : public Page {
 public:
  std::string title() const override { return "Recording"; }
  std::vector<Need> essential() const override;
  std::vector<Need> welcome(const Snapshot& known) const override;
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool click(const Snapshot& known, const Zone& zone, int x) override;
  bool animate(const Snapshot& known) override;
  bool leave_view() override;
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  /// Shows that run.
  void select(std::size_t run);
  std::vector<KeyHelp> keys() const override;
  std::string help() const override;

 private:
  bool press_run(const RecordingInput& input, Key key);
  bool press_hit(const RecordingInput& input, Key key, Command& command);
  bool press_replay(Key key);
  void zoom_on_hit(const RecordingInput& input);
  void next_rejected(const RecordingInput& input);

  RecordingState state_;
};

}  // namespace tapfit::tui
