#include "tests/tui/support/fake_workbench.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/fit/fit_observer.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/effect_change.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <numbers>
#include <thread>
#include <utility>

namespace tapfit::tui::testing {
namespace {

class FakeWorkbench final : public Workbench {
 public:
  explicit FakeWorkbench(const FakeOptions& options)
      : options_(options), added_(options.left_with) {
    if (options.ready_frfs) {
      bundle_.frfs = bundle_.folder / "measured.uff";
      bundle_.runs.clear();
    }
    if (options.unreadable) recordings_[1].samples.resize(0, 0);
    if (options.unreadable || options.hitless) hits_.runs[1].clear();
  }

  const acquisition::TestBundle& bundle() override { return bundle_; }
  bool has_model() override { return options_.model; }
  const structure::Deck& deck(const Progress&) override { return deck_; }
  const std::vector<acquisition::Recording>& recordings(
      const Progress&) override {
    return recordings_;
  }
  std::vector<acquisition::LeftOut> left_out() override {
    if (options_.hitless && sought_hits_) {
      return {
          {1,
           InputError("no hit was found", "run-02.wav", "lower the trigger")}};
    }
    if (!options_.unreadable) return {};
    return {
        {1, InputError("is no sound file", "run-02.wav", "record it again")}};
  }
  const acquisition::HitSet& hits(const Progress&) override {
    if (options_.hits_fail) {
      throw InputError(
          "no hit was found", "run-01.wav", "lower the trigger level");
    }
    sought_hits_ = true;
    return hits_;
  }
  std::vector<Finding> findings(const Progress&) override {
    return {
        {Severity::Error,
         {{1}, "acc1", {}, {}},
         "acc1 against acc2 is 3.16 times what it is in the other runs, in "
         "every mode",
         "the range or amplifier of acc1 or acc2 was changed for these runs",
         "take the run out"},
        {Severity::Note,
         {{}, "hammer", {}, {}},
         "only 0.5 % of the range "
         "is used",
         "",
         ""}};
  }
  const signal::FrfSet& frfs(const Progress& progress) override {
    progress("averaging", 0.5);
    return frfs_;
  }
  const modal::ModeSet& modes(const Progress& progress) override {
    while (options_.endless_modes) {
      progress("fitting", 0.43);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return modes_;
  }
  const updating::Comparison& comparison(const Progress&) override {
    const bool any = std::any_of(
        added_.begin(), added_.end(), [](const auto& e) { return e.on; });
    return any ? better_ : base_;
  }
  const updating::Comparison& base_comparison(const Progress&) override {
    return base_;
  }
  std::optional<updating::Diagnosis> known_diagnosis(
      std::size_t effects, const Progress& progress) override {
    progress("known diagnosis", 0.0);
    if (!options_.diagnosed_before) return std::nullopt;
    if (effects > 0 && !options_.diagnosed_on_the_way) return std::nullopt;
    return diagnosis_;
  }
  const updating::Diagnosis& robust_diagnosis(const Progress& p) override {
    diagnosis_.robustness = fake_robustness();
    return diagnosis(p);
  }
  const updating::Diagnosis& diagnosis(const Progress& progress) override {
    progress("hypotheses", 0.2);
    if (options_.endless_first_diagnosis && added_.empty()) {
      tell_tried(progress, diagnosis_.candidates.size());
      while (true) {
        progress("hypotheses", 0.3);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
    if (!added_.empty()) tell_tried(progress, options_.tried_after_adding);
    while (!added_.empty() &&
           (options_.endless_diagnosis ||
            (options_.diagnosis_held != nullptr && *options_.diagnosis_held))) {
      progress("hypotheses", 0.43);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (options_.reversed_after_adding && !added_.empty()) {
      std::ranges::reverse(diagnosis_.candidates);
    }
    return diagnosis_;
  }
  updating::Signature signature(int node, const Progress&) override {
    return fake_signature(node);
  }
  updating::EffectEvidence evidence(const updating::EffectRef&,
                                    const std::vector<updating::EffectRef>&,
                                    const Progress&) override {
    return updating::effect_evidence(base_, better_);
  }
  std::vector<updating::GridShare> localisation_map(const Progress&) override {
    return {{5, 0.97}, {6, 0.9}, {3, 0.6}, {1, 0.01}};
  }
  std::vector<updating::UpdateRecord> update_records(const Progress&) override {
    if (added_.empty()) return {};
    updating::UpdateRecord record;
    record.added = "added-mass";
    record.lines = "the damped line";
    record.converged = true;
    record.message = "converged";
    record.parameters = {"E:1", "added-mass mass_kg"};
    record.steps = {{0, 0.4, 0.0, 0.001, Eigen::Vector2d(6.0e10, 0.02)},
                    {0, 0.1, 0.3, 0.001, Eigen::Vector2d(7.0e10, 0.07)},
                    {1, 0.05, 0.1, 0.001, Eigen::Vector2d(7.07e10, 0.0785)}};
    record.correlation = Eigen::Matrix2d{{1.0, -0.42}, {-0.42, 1.0}};
    return {record};
  }
  std::string write(Output,
                    const std::filesystem::path& to,
                    bool,
                    const Progress&) override {
    return to.string();
  }
  std::vector<updating::Rung> ladder(const Progress&) override {
    std::vector<updating::Rung> rungs{{"base", {}, base_.error, {}}};
    for (const updating::AddedEffect& e : added_) {
      if (!e.on) continue;
      rungs.push_back({e.ref.effect,
                       e.ref.where,
                       better_.error,
                       {{"mass_kg", 0.0785, 0.0006, 0.0773, 0.0797}}});
    }
    return rungs;
  }
  std::vector<updating::Estimate> model_parameters(const Progress&) override {
    return {{"E:1", 7.07e10, 2.0e8, 7.03e10, 7.11e10}};
  }
  void overrule_hit(std::size_t run, std::size_t hit) override {
    acquisition::overrule(hits_.runs.at(run).at(hit));
  }
  // A mode edited away or put in: only their number is right.
  void choose_modes(const updating::ModeChoices& choices,
                    const Progress&) override {
    past_choices_.push_back(choices_);
    future_choices_.clear();
    take(choices);
  }
  updating::ModeChoices mode_choices() override { return choices_; }
  bool undo_modes(const Progress&) override {
    if (past_choices_.empty()) return false;
    future_choices_.push_back(choices_);
    take(past_choices_.back());
    past_choices_.pop_back();
    return true;
  }
  bool redo_modes(const Progress&) override {
    if (future_choices_.empty()) return false;
    past_choices_.push_back(choices_);
    take(future_choices_.back());
    future_choices_.pop_back();
    return true;
  }
  updating::EffectRef parse_effect(const std::string& text) override {
    if (text != "added-mass@5") {
      throw InputError("no such effect: " + text, ":add", "see the catalogue");
    }
    return {"added-mass", diagnosis_.candidates[0].where};
  }
  void add_together(const std::vector<updating::EffectRef>& effects,
                    const Progress& progress) override {
    while (options_.held != nullptr && *options_.held) {
      progress("fitting", 0.43);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (!options_.add_fails.empty()) {
      throw InputError(options_.add_fails, "", "");
    }
    past_.push_back(added_);
    added_ = updating::with_added(added_, effects);
    future_.clear();
  }
  void toggle(std::size_t effect, const Progress&) override {
    past_.push_back(added_);
    added_.at(effect).on = !added_.at(effect).on;
  }
  bool undo(const Progress&) override { return move(past_, future_); }
  bool redo(const Progress&) override { return move(future_, past_); }
  std::vector<updating::AddedEffect> effects() override { return added_; }
  updating::HitActs hit_acts() override { return {}; }
  std::optional<updating::HitActs> catch_up(const Progress&) override {
    if (!std::exchange(news_, false)) return std::nullopt;
    added_ = options_.other_window;
    return updating::HitActs{};
  }
  Saving save(const updating::HitActs&, const Progress&) override {
    news_ = !options_.other_window.empty() && !std::exchange(saved_, true);
    return {news_, options_.unsaved};
  }

 private:
  FakeOptions options_;
  bool news_ = false;
  bool saved_ = false;  ///< once, or it was tried
  bool sought_hits_ = false;
  acquisition::TestBundle bundle_ = fake_bundle();
  structure::Deck deck_ = fake_deck();
  std::vector<acquisition::Recording> recordings_ = fake_recordings();
  acquisition::HitSet hits_ = fake_hits();
  signal::FrfSet frfs_ = fake_frfs();
  modal::ModeSet modes_ = fake_modes();
  updating::Comparison base_ = fake_comparison(0.05);
  updating::Comparison better_ = fake_comparison(0.0);
  updating::Diagnosis diagnosis_ = fake_diagnosis();
  using Effects = std::vector<updating::AddedEffect>;

  void tell_tried(const Progress& progress, std::size_t first) {
    const updating::FitObserver* observer = updating::fit_observer(progress);
    if (observer == nullptr || !observer->tried) return;
    for (std::size_t i = 0; i < first; ++i) {
      observer->tried(diagnosis_.candidates[i]);
    }
  }

  bool move(std::vector<Effects>& from, std::vector<Effects>& to) {
    if (from.empty()) return false;
    to.push_back(added_);
    added_ = from.back();
    from.pop_back();
    return true;
  }

  void take(const updating::ModeChoices& choices) {
    choices_ = choices;
    modes_ = fake_modes();
    for (const modal::PoleEdit& edit : choices_.edits) {
      if (edit.what == modal::PoleEdit::What::Add) {
        modes_.modes.push_back(modes_.modes.back());
        modes_.modes.back().frequency_hz = edit.hz;
        continue;
      }
      const auto nearest =
          std::ranges::min_element(modes_.modes, {}, [&](const auto& mode) {
            return std::abs(mode.frequency_hz - edit.hz);
          });
      if (nearest == modes_.modes.end()) {
        throw InputError("no mode to drop", "modes", "");
      }
      modes_.modes.erase(nearest);
    }
  }

  updating::ModeChoices choices_;
  std::vector<updating::ModeChoices> past_choices_;
  std::vector<updating::ModeChoices> future_choices_;
  Effects added_;
  std::vector<Effects> past_;
  std::vector<Effects> future_;
};

}  // namespace

std::unique_ptr<Workbench> fake_workbench(const FakeOptions& options) {
  return std::make_unique<FakeWorkbench>(options);
}

}  // namespace tapfit::tui::testing
