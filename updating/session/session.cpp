#include "updating/session/session.hpp"

#include "updating/comparison/compare.hpp"
#include "updating/diagnosis/set_up_mistakes.hpp"
#include "updating/diagnosis/test_diagnosis.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/localisation/find_signature.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/prediction/predict_change.hpp"
#include "updating/reduction/base_error.hpp"
#include "updating/robustness/robustness.hpp"
#include "updating/session/effect_change.hpp"
#include "updating/session/find_evidence.hpp"
#include "updating/session/fitted_test.hpp"
#include "updating/session/session_stages.hpp"
#include "updating/session/test_of_modes.hpp"
#include "updating/session/weighed_mass.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tapfit::updating {

Session::Session(const std::filesystem::path& bundle,
                 acquisition::Unreadable unreadable)
    : stages_(std::make_unique<SessionStages>(bundle, unreadable)) {}
Session::Session(std::unique_ptr<SessionStages> stages)
    : stages_(std::move(stages)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Session Session::beside() const {
  auto stages = std::make_unique<SessionStages>(stages_->test);
  stages->waiting =
      stages_->ground ? stages_->stack->history() : stages_->waiting;
  stages->choice = stages_->choice;
  stages->diagnosis = stages_->diagnosis;
  stages->form_error = stages_->form_error;
  stages->put_right = stages_->put_right;
  return Session(std::move(stages));
}

const acquisition::TestBundle& Session::bundle() const {
  return stages_->test.bundle();
}
bool Session::has_model() const { return bundle().deck || bundle().matrices; }
const std::vector<acquisition::Recording>& Session::recordings(
    const Progress& progress) {
  return stages_->test.recordings(progress);
}
const std::vector<acquisition::LeftOut>& Session::left_out() const {
  return stages_->test.left_out();
}
const acquisition::HitSet& Session::hits(const Progress& progress) {
  return stages_->test.hits(progress);
}
const signal::FrfSet& Session::frfs(const Progress& progress) {
  return stages_->test.frfs(progress);
}
signal::FrfSet Session::frfs_as(const signal::FrfOptions& options,
                                const Progress& progress) {
  return stages_->test.frfs_as(options, progress);
}
const modal::ModeSet& Session::modes(const Progress& progress) {
  return stages_->test.modes(progress);
}

const structure::Deck& Session::deck(const Progress& progress) {
  return stages_->read_model(progress);
}

const Comparison& Session::base_comparison(const Progress& progress) {
  if (!stages_->base_comparison) {
    stages_->prepare_fit(progress);
    stages_->base_comparison =
        stages_->compare_now(stages_->stack->fits().front());
  }
  return *stages_->base_comparison;
}

const Comparison& Session::comparison(const Progress& progress) {
  if (!stages_->comparison) {
    stages_->prepare_fit(progress);
    stages_->comparison = stages_->compare_now(stages_->current());
    stages_->limit_floor(*stages_->comparison, progress);
  }
  return *stages_->comparison;
}

const Diagnosis& Session::diagnosis(const Progress& progress) {
  if (stages_->diagnosis) return *stages_->diagnosis;
  const Comparison& base = base_comparison(progress);
  const Fit& now = stages_->current();
  stages_->diagnosis =
      stages_->diagnosis_cache(now.effects.size()).kept_or_made([&] {
        return diagnose_test(stages_->ground_now(),
                             now,
                             base,
                             stages_->measured(),
                             model_warnings(progress),
                             progress);
      });
  stages_->take_floor(*stages_->diagnosis, progress);
  return *stages_->diagnosis;
}

const Diagnosis& Session::robust_diagnosis(const Progress& progress) {
  if (!diagnosis(progress).robustness.empty()) return *stages_->diagnosis;
  const TwofoldDiagnosis cut =
      cut_at_deck(*stages_->diagnosis, stages_->context());
  const FitContext& ground =
      cut.corrections.empty() ? stages_->ground_now()
                              : stages_->ground_of(cut.corrections, progress);
  const DiagnoseOptions options = options_of_test(ground);
  std::vector<Robustness>& firm = stages_->diagnosis->robustness;
  firm = robustness(*ground.fitter, options, cut.rest, progress);
  for (Robustness& one : firm) one.verdict = with_named(cut.named, one.verdict);
  stages_->diagnosis_cache(stages_->current().effects.size())
      .keep(*stages_->diagnosis);
  return *stages_->diagnosis;
}

std::optional<Diagnosis> Session::known_diagnosis(std::size_t effects,
                                                  const Progress& progress) {
  stages_->prepare_fit(progress);
  std::optional<Diagnosis> known = stages_->diagnosis_cache(effects).load();
  if (known) stages_->take_floor(*known, progress);
  return known;
}

Signature Session::signature(int node, const Progress& progress) {
  stages_->prepare_fit(progress);
  static_cast<void>(stages_->deck->grid_index(node));
  return signature_at(
      stages_->current(), *stages_->ground_now().fitter, node, progress);
}

EffectEvidence Session::evidence(const EffectRef& effect,
                                 const std::vector<EffectRef>& added,
                                 const Progress& progress) {
  stages_->prepare_fit(progress);
  return find_evidence(*stages_, effect, added, progress);
}

Prediction Session::predict(const std::vector<StatedChange>& changes,
                            const Progress& progress) {
  stages_->prepare_fit(progress);
  if (stages_->stack->fits().size() == 1) fit_uncertain(progress);
  return predict_change({stages_->current(),
                         *stages_->ground_now().fitter,
                         comparison(progress),
                         frfs(progress),
                         modes(progress)},
                        changes,
                        progress);
}

std::vector<GridShare> Session::localisation_map(const Progress& progress) {
  stages_->prepare_fit(progress);
  return updating::localisation_map(
      stages_->current(), stages_->ground_now().fitter->target(), progress);
}

void Session::overrule_hit(std::size_t run, std::size_t hit) {
  if (stages_->test.overrule({run, hit})) stages_->drop_from_frfs();
}

void Session::choose_modes(const ModeChoices& choices,
                           const Progress& progress) {
  const ModeChoices before = mode_choices();
  if (choices == before) return;
  stages_->change_modes(choices, progress);
  stages_->past_choices.push_back(before);
  stages_->future_choices.clear();
}

const ModeChoices& Session::mode_choices() const {
  return stages_->test.choices();
}

bool Session::undo_modes(const Progress& progress) {
  return stages_->move_choices(
      stages_->past_choices, stages_->future_choices, progress);
}

bool Session::redo_modes(const Progress& progress) {
  return stages_->move_choices(
      stages_->future_choices, stages_->past_choices, progress);
}

void Session::add_together(const std::vector<EffectRef>& effects,
                           const Progress& progress) {
  stages_->prepare_fit(progress);
  if (bundle().modes) check_shown_in_modes(effects);
  stages_->stack->add_together(effects, stages_->stack_fit(), progress);
  stages_->drop_current();
}

void Session::toggle(std::size_t effect, const Progress& progress) {
  stages_->prepare_fit(progress);
  stages_->stack->toggle(effect, stages_->stack_fit(), progress);
  stages_->drop_current();
}

void Session::fit_uncertain(const Progress& progress) {
  stages_->prepare_fit(progress);
  stages_->stack->fit_uncertain(stages_->stack_fit(), progress);
  stages_->drop_current();
}

bool Session::undo(const Progress& progress) {
  if (!stages_->ground && stages_->waiting.now.empty()) return false;
  stages_->prepare_fit(progress);
  if (!stages_->stack->undo(stages_->stack_fit(), progress)) return false;
  stages_->drop_current();
  return true;
}

bool Session::redo(const Progress& progress) {
  if (!stages_->ground && stages_->waiting.future.empty()) return false;
  stages_->prepare_fit(progress);
  if (!stages_->stack->redo(stages_->stack_fit(), progress)) return false;
  stages_->drop_current();
  return true;
}

std::vector<AddedEffect> Session::effects() const {
  return stages_->ground ? stages_->stack->effects() : stages_->waiting.now;
}

const std::vector<OverruledHit>& Session::overruled() const {
  return stages_->test.overruled();
}

SavedSession Session::saved(const Progress& progress) {
  SavedSession result;
  result.title = bundle().title;
  result.overruled = overruled();
  result.modes = mode_choices();
  result.effects = effects();
  const EffectHistory& history =
      stages_->ground ? stages_->stack->history() : stages_->waiting;
  result.undone = changes_through(history.now, history.future);
  result.kept = history.kept;
  if (!stages_->ground) return result;
  for (const Rung& rung : ladder(progress)) {
    const Fit& fit = stages_->stack->fits()[result.ladder.size()];
    result.ladder.push_back({rung, stages_->compare_now(fit).pairs});
  }
  return result;
}

void Session::take_up(const SavedSession& saved) {
  if (bundle().modes) check_saved_shown_in_modes(saved);
  stages_->test.set_overruled(overruled_now(saved.overruled));
  stages_->test.set_choices(saved.modes);
  stages_->waiting.now = saved.effects;
  stages_->waiting.future = states_through(saved.effects, saved.undone);
  stages_->waiting.kept = saved.kept;
}

void Session::set_update(const UpdateChoice& choice) {
  if (bundle().modes) check_choice_for_modes(choice);
  if (const auto& band = bundle().band_hz) check_lines(choice.lines, *band);
  stages_->choice = choice;
  stages_->plain.reset();
}

FittedTest Session::fitted(const Progress& progress) {
  stages_->prepare_fit(progress);
  return {*stages_->ground_now().fitter,
          stages_->stack->fits().front(),
          stages_->current(),
          stages_->ground->properties,
          stages_->context()};
}

std::vector<UpdateRecord> Session::update_records(const Progress& progress) {
  stages_->prepare_fit(progress);
  return records_of(
      stages_->stack->fits(),
      stages_->context(),
      stages_->ground->properties,
      stages_->plain ? stages_->plain->lines : stages_->ground->contour);
}

std::vector<SetUpMistake> Session::run_outliers(const Progress& progress) {
  stages_->prepare_fit(progress);
  // With what is uncertain fitted, where it was.
  const std::vector<Fit>& fits = stages_->stack->fits();
  const Fit& without_effects =
      *std::find_if(fits.rbegin(), fits.rend(), [](const Fit& fit) {
        return fit.effects.empty();
      });
  return updating::run_outliers(stages_->ground->fitter->problem().foreign,
                                bundle().runs.size(),
                                without_effects.result.error);
}

std::vector<std::string> Session::model_warnings(const Progress& progress) {
  stages_->prepare_fit(progress);
  std::vector<std::string> warnings = stages_->model->unsplit().warnings();
  if (const auto mass =
          weighed_mass_finding(bundle(), stages_->model->builder.mass_kg())) {
    warnings.push_back(statement(*mass));
  }
  warnings.push_back(floor_warning(base_comparison(progress)));
  warnings.push_back(base_error_warning(stages_->model->builder.error()));
  if (bundle().modes) {
    std::ranges::copy(stages_->ground->fitter->problem().measured.statements,
                      std::back_inserter(warnings));
  } else {
    warnings.push_back(mesh_warning(*stages_->model));
  }
  for (const SetUpMistake& run : run_outliers(progress)) {
    warnings.push_back(describe(run));
  }
  std::erase(warnings, "");
  return warnings;
}

double Session::base_error(const Progress& progress) {
  stages_->prepare_fit(progress);
  return stages_->model->builder.error();
}

const std::vector<Rung>& Session::ladder(const Progress& progress) {
  stages_->prepare_fit(progress);
  if (stages_->ladder.empty()) {
    std::vector<Fit> fits = stages_->stack->fits();
    fits.back() = stages_->current_likeliest();
    stages_->ladder = rungs_of(fits, stages_->context());
  }
  return stages_->ladder;
}

std::vector<Estimate> Session::model_parameters(const Progress& progress) {
  stages_->prepare_fit(progress);
  return all_estimates(stages_->current_likeliest(),
                       stages_->ground->properties,
                       stages_->context());
}

std::vector<ModelForm> Session::model_form(const Progress& progress) {
  stages_->prepare_fit(progress);
  return updating::model_form(stages_->current_likeliest(), deck(progress));
}

}  // namespace tapfit::updating
