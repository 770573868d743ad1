// Screen 1: a run's channels against time, its hits and what is thought of
// each.
#pragma once

#include "tui/plot_range.hpp"
#include "tui/views/page.hpp"

namespace tapfit::tui {

struct RecordingInput {
  const acquisition::TestBundle& bundle;
  const std::vector<Trace>& traces;
  const acquisition::HitSet& hits;
};

struct RecordingState {
  std::size_t run = 0;
  std::size_t sensor = 0;  ///< which of the run's sensors is drawn
  ListState list;          ///< the run's hits
  PlotRange range;         ///< [s]
};

[[nodiscard]] Screen recording_view(const RecordingInput& input,
                                    const RecordingState& state,
                                    const Canvas& canvas);

class RecordingPage final : public Page {
 public:
  std::string title() const override { return "Recording"; }
  std::vector<Need> essential() const override;
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  std::vector<KeyHelp> keys() const override;
  std::string help() const override;

 private:
  RecordingState state_;
};

}  // namespace tapfit::tui
