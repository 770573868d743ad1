// Screen 4: where the model fails: error per FRF and band, per mode, per
// measured point; the curves behind each number below.
#pragma once

#include "tui/views/compared_modes.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/views/page.hpp"
#include "tui/widgets/plot_range.hpp"

#include <utility>

namespace tapfit::tui {

struct CompareState {
  ListState list;   ///< FRFs
  PlotRange range;  ///< [Hz]
  MagnitudeScale scale = MagnitudeScale::Logarithmic;
  /// What the keys move in.
  enum class Focus { Frfs, Map, Pairs, Mac, Structure } focus = Focus::Frfs;
  std::size_t band = 0;  ///< column of the map
  ListState pairs;
  std::size_t mac_row = 0;
  std::size_t mac_column = 0;
  std::size_t point = 0;  ///< of the measured points, the worst first
  Pose pose;
};

[[nodiscard]] Screen compare_view(const CompareInput& input,
                                  const CompareState& state,
                                  const Canvas& canvas);

/// "error 38.8 % (floor 3.1 %: noise 1.0 %, mesh 3.0 %)"
[[nodiscard]] std::string error_sentence(const updating::Comparison& c);

/// Measured grids with their error, the worst first.
[[nodiscard]] std::vector<std::pair<int, double>> worst_points(
    const updating::Comparison& c);

[[nodiscard]] Table compared_frfs(const CompareInput& input);

/// All FRFs in the order of that list, whatever its filter hides.
[[nodiscard]] std::vector<std::size_t> frf_order(const CompareInput& input,
                                                 const ListState& list);

class ComparePage final : public Page {
 public:
  explicit ComparePage(MagnitudeScale scale) { state_.scale = scale; }
  std::string title() const override { return "Compare"; }
  bool wants_model() const override { return true; }
  std::vector<Need> essential() const override {
    return {{Stage::Frfs}, {Stage::Comparison}};
  }
  std::vector<Need> welcome(const Snapshot&) const override {
    return {{Stage::Model}, {Stage::Modes}};
  }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool click(const Snapshot& known, const Zone& zone, int x) override;
  bool leave_view() override {
    using Focus = CompareState::Focus;
    return std::exchange(state_.focus, Focus::Frfs) != Focus::Frfs;
  }
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  std::vector<KeyHelp> keys(const Snapshot& known) const override;
  std::string help() const override;

 private:
  bool move(const CompareInput& input, Key key);
  bool sort(const CompareInput& input, Key key, Command& command);
  bool press_modes_alone(const CompareInput& input, Key key, Command& command);
  void enter(const CompareInput& input, Command& command);
  void look_at(const CompareInput& input, double low_hz, double high_hz);
  [[nodiscard]] bool looks_at(double low_hz, double high_hz) const;

  CompareState state_;
};

}  // namespace tapfit::tui
