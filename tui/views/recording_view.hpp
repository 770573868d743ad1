// Screen 1: a run's channels against time, its hits and what is thought of
// each, how well they agree, and the average that they give; the run replayed
// as if it were being measured.
#pragma once

#include "tui/views/page.hpp"
#include "tui/views/recording_state.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/workbench/run_look.hpp"

namespace tapfit::tui {

[[nodiscard]] Screen recording_view(const RecordingInput& input,
                                    const RecordingState& state,
                                    const Canvas& canvas);

class RecordingPage final : public Page {
 public:
  std::string title() const override { return "Recording"; }
  std::string nothing_here(
      const acquisition::TestBundle& bundle) const override;
  std::vector<Need> essential() const override;
  std::vector<Need> welcome(const Snapshot& known) const override;
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool click(const Snapshot& known, const Zone& zone, int x) override;
  bool animate(const Snapshot& known) override;
  bool leave_view() override;
  ListState* list() override {
    return state_.overview ? &state_.runs : &state_.list;
  }
  PlotRange* range() override {
    return state_.overview ? nullptr : &state_.range;
  }
  /// Shows that run.
  void select(std::size_t run);
  std::vector<KeyHelp> keys(const Snapshot& known) const override;
  std::string help() const override;

 private:
  bool press_overview(const RecordingInput& input, Key key, Command& command);
  bool press_findings(const RecordingInput& input, Key key);
  bool press_run(const RecordingInput& input, Key key);
  bool press_hit(const RecordingInput& input, Key key, Command& command);
  bool press_replay(Key key);
  void zoom_on_hit(const RecordingInput& input);
  void next_rejected(const RecordingInput& input);

  RecordingState state_;
};

}  // namespace tapfit::tui
