// What the keys of the Update screen do.
#include "tui/views/diagnose_details.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/views/update_view.hpp"
#include "tui/workbench/diagnosed_effects.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::tui {
namespace {

/// Whose it is in Snapshot::effect_evidence; none where nothing is marked.
std::optional<int> marked_evidence(const Snapshot& known,
                                   const UpdateState& state) {
  if (state.uncertain) return of_uncertain;
  if (known.effects.empty()) return std::nullopt;
  return static_cast<int>(selected_effect(known.effects, state));
}

bool has_uncertain(const Snapshot& known) {
  return std::ranges::any_of(*known.ladder, [](const updating::Rung& rung) {
    return rung.added == updating::uncertain_rung;
  });
}

/// What a diagnosis said that the marked effect cannot be told from.
std::string look_alikes(const Snapshot& known, const UpdateState& state) {
  if (known.effects.empty() || state.uncertain) return {};
  const updating::EffectRef& effect =
      known.effects[selected_effect(known.effects, state)].ref;
  for (const auto& [effects, diagnosis] : known.diagnoses) {
    for (const updating::Candidate& candidate : diagnosis->candidates) {
      if (ref_of(candidate) != effect) continue;
      if (candidate.indistinguishable_from.empty()) return {};
      return indistinguishable(
          *diagnosis, candidate, known.bundle->modes.has_value());
    }
  }
  return {};
}

}  // namespace

std::vector<Need> UpdatePage::welcome(const Snapshot& known) const {
  std::vector<Need> needs{
      {Stage::Model}, {Stage::Comparison}, {Stage::BaseComparison}};
  using Panel = UpdateState::Panel;
  if (state_.panel == Panel::Curves) return needs;
  if (state_.panel != Panel::Evidence) {
    needs.push_back({Stage::Records});
  } else if (const auto marked = marked_evidence(known, state_)) {
    needs.push_back({Stage::EffectEvidence, *marked});
  }
  return needs;
}

Screen UpdatePage::draw(const Snapshot& known, const Canvas& canvas) const {
  const auto found = known.effect_evidence.find(
      marked_evidence(known, state_).value_or(of_uncertain));
  return update_view(
      {*known.frfs,
       *known.ladder,
       *known.parameters,
       known.effects,
       known.base_comparison.get(),
       known.comparison.get(),
       known.previous.get(),
       known.records.get(),
       found == known.effect_evidence.end() ? nullptr : found->second.get(),
       known.bundle.get(),
       known.deck.get(),
       known.wire.get(),
       look_alikes(known, state_)},
      state_,
      canvas);
}

void UpdatePage::mark(const Snapshot& known, bool next) {
  const std::size_t effect = selected_effect(known.effects, state_);
  if (next) {
    state_.effect = std::exchange(state_.uncertain, false) ? 0 : effect + 1;
  } else if (effect == 0 || state_.uncertain) {
    state_.uncertain = has_uncertain(known);
  } else {
    state_.effect = effect - 1;
  }
}

bool UpdatePage::press(const Snapshot& known, Key key, Command& command) {
  if (key == U'x') {
    state_.scale = next(state_.scale);
  } else if (key == keys::tab) {
    constexpr int panels = static_cast<int>(UpdateState::Panel::LCurve) + 1;
    state_.panel = static_cast<UpdateState::Panel>(
        (static_cast<int>(state_.panel) + 1) % panels);
  } else if (key == U'R') {
    state_.slide = 0.0;
  } else if (key == U'n' || key == U'p') {
    mark(known, key == U'n');
  } else if (key == U' ' && state_.uncertain) {
    command.message = "what is uncertain is part of every fit: n marks effects";
  } else if (key == U' ') {
    command.kind = Command::Kind::Toggle;
    command.added = selected_effect(known.effects, state_);
  } else if (state_.panel == UpdateState::Panel::Evidence &&
             pose_key(state_.pose, key)) {
    return true;
  } else if (!list_key(state_.list, frf_names(*known.frfs), key)) {
    const FrequencySpan span = frequency_span(*known.frfs);
    return range_key(
        state_.range, key, span.lo, span.hi, line_spacing(*known.frfs));
  }
  return true;
}

bool UpdatePage::animate(const Snapshot& known) {
  if (known.comparison && known.comparison != seen_) {
    seen_ = known.comparison;
    state_.slide = known.previous ? 0.0 : 1.0;
  }
  if (state_.slide >= 1.0) return false;
  constexpr double step = 0.06;  // about a second from curve to curve
  state_.slide = std::min(1.0, state_.slide + step);
  return true;
}

std::vector<KeyHelp> UpdatePage::keys(const Snapshot&) const {
  return {{"j k", "FRF"},
          {"Tab", "view"},
          {"Space", "effect off/on"},
          {"u", "undo"},
          {"^R", "redo"},
          {"n p", "which"},
          {"R", "slide again"},
          {"h l", "cursor"},
          {"x", "log/lin/dB"},
          {"+ -", "zoom"},
          {"[ ]", "pan"},
          {"_", "whole band"},
          {"/", "filter"}};
}

std::string UpdatePage::help() const {
  return "The current model: its uncertain properties and the parameters of "
         "what was added, ± one standard deviation, and how the error fell "
         "with each effect (the mark on a bar is the floor). Below, the "
         "updated model over the measurement, with the base model for "
         "comparison. u takes the last change back, Ctrl-R does it again. "
         "Space switches the marked effect off or on, n and p mark another. "
         "Tab shows what it does (the FRF where it shows most, with and "
         "without it, and where it sits), then how its fit came about: its "
         "residual and parameters step "
         "by "
         "step, the correlation of the estimates, and the L-curve (how far the "
         "parameters had to move, |x|, for what is left, |S x - d|). A mesh "
         "correction takes up what the mesh does to the modes. While a fit "
         "runs, S ends it and keeps what it has "
         "reached, Esc discards it.";
}

}  // namespace tapfit::tui
