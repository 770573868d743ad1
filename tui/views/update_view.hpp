// Screen 6: the updated model's parameters, and its curve sliding onto the
// measurement.
#pragma once

#include "tui/views/frf_curves.hpp"
#include "tui/views/page.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/widgets/wireframe.hpp"
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
  /// What the marked effect does, once it is known, and where it is.
  const updating::EffectEvidence* evidence = nullptr;
  const acquisition::TestBundle* bundle = nullptr;
  const structure::Deck* deck = nullptr;
  const Wireframe* wire = nullptr;
  /// What the marked effect cannot be told from, in words; empty: nothing.
  std::string look_alikes = {};
};

struct UpdateState {
  ListState list;  ///< FRFs
  /// Of those added: the one that t switches; empty: the latest.
  std::optional<std::size_t> effect = {};
  bool uncertain = false;  ///< what is uncertain is marked, and no effect
  PlotRange range;         ///< [Hz]
  MagnitudeScale scale = MagnitudeScale::Logarithmic;
  enum class Panel {
    Curves,
    Evidence,  ///< the marked effect's
    Convergence,
    Correlation,
    LCurve
  } panel = Panel::Curves;
  Pose pose;           ///< of the structure
  double slide = 1.0;  ///< 0: the previous model's curve, 1: the current one
};

/// The one that is marked, counted from 0; 0 without any.
[[nodiscard]] std::size_t selected_effect(
    const std::vector<updating::AddedEffect>& effects,
    const UpdateState& state);

/// A row for each FRF.
[[nodiscard]] Table frf_names(const signal::FrfSet& frfs);

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
  std::vector<Need> welcome(const Snapshot& known) const override;
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool leave_view() override {
    using Panel = UpdateState::Panel;
    return std::exchange(state_.panel, Panel::Curves) != Panel::Curves;
  }
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return has_curves() ? &state_.range : nullptr; }
  bool animate(const Snapshot& known) override;
  /// Marks the effect that was added last.
  void mark_latest() {
    state_.effect.reset();
    state_.uncertain = false;
  }
  std::vector<KeyHelp> keys(const Snapshot& known) const override;
  std::string help() const override;

 private:
  /// Marks the next or the one before; what is uncertain stands first.
  void mark(const Snapshot& known, bool next);
  /// Over frequency.
  [[nodiscard]] bool has_curves() const {
    return state_.panel == UpdateState::Panel::Curves ||
           state_.panel == UpdateState::Panel::Evidence;
  }

  UpdateState state_;
  /// Only told apart from the next one, never looked into; held, so that its
  /// address is not given to another.
  std::shared_ptr<const updating::Comparison> seen_;
};

}  // namespace tapfit::tui
