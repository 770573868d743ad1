// Screen 6: the updated model's parameters, and its curve sliding onto the
// measurement.
#pragma once

#include "tui/views/frf_curves.hpp"
#include "tui/views/page.hpp"
#include "tui/widgets/plot_range.hpp"
#include "updating/fit/update_record.hpp"
#include "updating/session/added_effect.hpp"

#include <optional>
#include <utility>

namespace tapfit::tui {

struct UpdateInput {
  const signal::FrfSet& frfs;
  const std::vector<updating::Rung>& ladder;
  const std::vector<updating::Estimate>& parameters;
  const std::vector<updating::AddedEffect>& effects;  ///< also those off
  const updating::Comparison* base = nullptr;
  const updating::Comparison* current = nullptr;
  const updating::Comparison* previous = nullptr;  ///< where to slide from
  /// How the ladder's fits came about, once it is known.
  const std::vector<updating::UpdateRecord>* records = nullptr;
};

struct UpdateState {
  ListState list;  ///< FRFs
  /// Of those added: the one that t switches; empty: the latest.
  std::optional<std::size_t> effect = {};
  PlotRange range;  ///< [Hz]
  MagnitudeScale scale = MagnitudeScale::Logarithmic;
  enum class Panel {
    Curves,
    Convergence,
    Correlation,
    LCurve
  } panel = Panel::Curves;
  double slide = 1.0;  ///< 0: the previous model's curve, 1: the current one
};

[[nodiscard]] Screen update_view(const UpdateInput& input,
                                 const UpdateState& state,
                                 const Canvas& canvas);

class UpdatePage final : public Page {
 public:
  explicit UpdatePage(MagnitudeScale scale) { state_.scale = scale; }
  std::string title() const override { return "Update"; }
  bool wants_model() const override { return true; }
  std::vector<Need> essential() const override {
    return {{Stage::Frfs}, {Stage::Ladder}};
  }
  std::vector<Need> welcome(const Snapshot&) const override {
    std::vector<Need> needs{{Stage::Comparison}, {Stage::BaseComparison}};
    if (state_.panel != UpdateState::Panel::Curves) {
      needs.push_back({Stage::Records});
    }
    return needs;
  }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool leave_view() override {
    using Panel = UpdateState::Panel;
    return std::exchange(state_.panel, Panel::Curves) != Panel::Curves;
  }
  ListState* list() override { return &state_.list; }
  PlotRange* range() override {
    const bool curves = state_.panel == UpdateState::Panel::Curves;
    return curves ? &state_.range : nullptr;
  }
  bool animate(const Snapshot& known) override;
  /// Marks the effect that was added last.
  void mark_latest() { state_.effect.reset(); }
  std::vector<KeyHelp> keys() const override;
  std::string help() const override;

 private:
  UpdateState state_;
  /// Only told apart from the next one, never looked into; held, so that its
  /// address is not given to another.
  std::shared_ptr<const updating::Comparison> seen_;
};

}  // namespace tapfit::tui
