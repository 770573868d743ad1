#include "updating/session/session.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/comparison/compare.hpp"
#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/test_diagnosis.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/fit/fit_ground.hpp"
#include "updating/fit/plain_fit.hpp"
#include "updating/localisation/find_signature.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/measurement/measurement.hpp"
#include "updating/measurement/test_model.hpp"
#include "updating/prediction/predict_change.hpp"
#include "updating/reduction/base_error.hpp"
#include "updating/robustness/robustness.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/effect_stack.hpp"
#include "updating/session/kept_diagnosis.hpp"
#include "updating/session/test_of_modes.hpp"

#include <algorithm>
#include <iterator>

namespace tapfit::updating {

struct Session::Impl {
  Impl(const std::filesystem::path& folder, acquisition::Unreadable unreadable)
      : test(folder, unreadable) {}

  Measurement test;
  std::optional<structure::Deck> deck;
  std::optional<SolvedModel> model;
  std::optional<FitGround> ground;  // and with it the stack
  std::optional<EffectStack> stack;
  std::vector<ModeChoices> past_choices;
  std::vector<ModeChoices> future_choices;
  EffectHistory waiting;  // to be in the stack, once there is one
  UpdateChoice choice;
  std::optional<PlainTask> plain;  // where the choice is a plain one
  std::optional<Comparison> base_comparison;
  std::optional<Comparison> comparison;
  std::optional<Diagnosis> diagnosis;
  std::vector<Rung> ladder;

  void drop_from_frfs();
  void change_modes(const ModeChoices& choices, const Progress& progress);
  bool move_choices(std::vector<ModeChoices>& from,
                    std::vector<ModeChoices>& to,
                    const Progress& progress);
  void drop_current();
  void stack_waiting(const Progress& progress);
  void prepare_fit(Session& session, const Progress& progress);
  [[nodiscard]] Fit fit_now(const std::vector<PlacedEffect>& effects,
                            const Fit& before,
                            const Progress& progress);
  [[nodiscard]] Comparison compare_now(const Fit& fit);
  [[nodiscard]] DiagnosisKeeper keeper(std::size_t effects);
  [[nodiscard]] StackFit stack_fit();
  [[nodiscard]] MeasuredTest measured();
  [[nodiscard]] const Fit& current() const { return stack->fits().back(); }
  [[nodiscard]] effects::Setting setting() const;
};

Session::Session(const std::filesystem::path& bundle,
                 acquisition::Unreadable unreadable)
    : impl_(std::make_unique<Impl>(bundle, unreadable)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const acquisition::TestBundle& Session::bundle() const {
  return impl_->test.bundle();
}
bool Session::has_model() const { return bundle().deck || bundle().matrices; }
const std::vector<acquisition::Recording>& Session::recordings(
    const Progress& progress) {
  return impl_->test.recordings(progress);
}
const std::vector<acquisition::LeftOut>& Session::left_out() const {
  return impl_->test.left_out();
}
const acquisition::HitSet& Session::hits(const Progress& progress) {
  return impl_->test.hits(progress);
}
const signal::FrfSet& Session::frfs(const Progress& progress) {
  return impl_->test.frfs(progress);
}
signal::FrfSet Session::frfs_as(const signal::FrfOptions& options,
                                const Progress& progress) {
  return impl_->test.frfs_as(options, progress);
}
const modal::ModeSet& Session::modes(const Progress& progress) {
  return impl_->test.modes(progress);
}

const structure::Deck& Session::deck(const Progress& progress) {
  if (impl_->deck) return *impl_->deck;
  progress("model: reading", 0.0);
  impl_->deck = read_test_model(bundle());
  return *impl_->deck;
}

effects::Setting Session::Impl::setting() const {
  effects::Setting s;
  s.bundle = &test.bundle();
  s.deck = &*deck;
  s.mass_kg = model->builder.mass_kg();
  s.low_hz = test.band()[0];
  s.high_hz = test.band()[1];
  s.component = measured_component(test.bundle(), *deck);
  s.components = tested_components(test.bundle(), *deck);
  return s;
}

// Model, damped lines and the base fit; all that does not depend on effects.
void Session::Impl::prepare_fit(Session& session, const Progress& progress) {
  if (ground) return;
  const structure::Deck& the_deck = session.deck(progress);
  static_cast<void>(test.modes(progress));
  if (!model) {
    model = solve_model(the_deck, test.bundle(), test.band()[1], progress);
  }
  ground = prepare_fits(*model, measured(), progress);
  stack.emplace(ground->base, !test.bundle().uncertain.empty());
  stack_waiting(progress);
}

MeasuredTest Session::Impl::measured() {
  return {setting(), test, test.modes({})};
}

StackFit Session::Impl::stack_fit() {
  return {setting(), std::bind_front(&Impl::fit_now, this)};
}

Fit Session::Impl::fit_now(const std::vector<PlacedEffect>& effects,
                           const Fit& before,
                           const Progress& progress) {
  const Fitter& fitter = *ground->fitter;
  const auto base = fitter.model_for(effects);
  if (!choice.is_plain()) return fitter.fit(effects, base, progress, &before);
  if (!plain) {
    plain = plain_task(
        choice,
        measured(),
        {fitter.target(), ground->contour, test.frfs({}).s.real().minCoeff()},
        progress);
  }
  return plain_fit(fitter, *plain, effects, base, before);
}

// With the first so many effects. Fits asked for in another way, and what is
// uncertain fitted before any effect, end elsewhere.
DiagnosisKeeper Session::Impl::keeper(std::size_t effects) {
  const bool usual = !choice.is_plain() &&
                     (stack->fits().size() != 2 || !current().effects.empty());
  return {usual ? user_cache() : std::nullopt,
          {test.bundle(),
           *deck,
           test.frfs({}),
           test.modes({}),
           test.choices().pairs},
          stack->history(),
          effects};
}

Comparison Session::Impl::compare_now(const Fit& fit) {
  Comparison c = compare(fit,
                         ground->fitter->target(),
                         test.frfs({}),
                         test.modes({}),
                         test.choices().pairs);
  c.floor_noise = ground->floor_noise;
  c.floor_mesh = ground->floor_mesh;
  const double data =
      evidence_data(ground->fitter->target(),
                    fit.result.residual,
                    static_cast<int>(test.modes({}).modes.size()));
  c.floor_form = form_share(fit, data, c.floor_noise).error;
  c.floor = std::hypot(c.floor_noise, c.floor_mesh, c.floor_form);
  c.contour = ground->contour;
  return c;
}

const Comparison& Session::base_comparison(const Progress& progress) {
  if (!impl_->base_comparison) {
    impl_->prepare_fit(*this, progress);
    impl_->base_comparison = impl_->compare_now(impl_->stack->fits().front());
  }
  return *impl_->base_comparison;
}

const Comparison& Session::comparison(const Progress& progress) {
  if (!impl_->comparison) {
    impl_->prepare_fit(*this, progress);
    impl_->comparison = impl_->compare_now(impl_->current());
  }
  return *impl_->comparison;
}

const Diagnosis& Session::diagnosis(const Progress& progress) {
  if (impl_->diagnosis) return *impl_->diagnosis;
  const Comparison& base = base_comparison(progress);
  const Fit& now = impl_->current();
  impl_->diagnosis = impl_->keeper(now.effects.size()).kept_or_made([&] {
    return diagnose_test(*impl_->ground,
                         now,
                         base,
                         impl_->measured(),
                         model_warnings(progress),
                         progress);
  });
  return *impl_->diagnosis;
}

const Diagnosis& Session::robust_diagnosis(const Progress& progress) {
  if (!diagnosis(progress).robustness.empty()) return *impl_->diagnosis;
  const DiagnoseOptions options = options_of_test(
      *impl_->ground, base_comparison(progress), impl_->measured());
  impl_->diagnosis->robustness =
      robustness(*impl_->ground->fitter, options, *impl_->diagnosis, progress);
  impl_->keeper(impl_->current().effects.size()).keep(*impl_->diagnosis);
  return *impl_->diagnosis;
}

std::optional<Diagnosis> Session::known_diagnosis(std::size_t effects,
                                                  const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return impl_->keeper(effects).load();
}

Signature Session::signature(int node, const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  static_cast<void>(impl_->deck->grid_index(node));
  return signature_at(impl_->current(), *impl_->ground->fitter, node, progress);
}

Prediction Session::predict(const std::vector<StatedChange>& changes,
                            const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  if (impl_->stack->fits().size() == 1) fit_uncertain(progress);
  return predict_change({impl_->current(),
                         *impl_->ground->fitter,
                         comparison(progress),
                         frfs(progress),
                         modes(progress)},
                        changes,
                        progress);
}

std::vector<GridShare> Session::signature_map(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return updating::signature_map(
      impl_->current(), impl_->ground->fitter->target(), progress);
}

void Session::Impl::drop_current() {
  comparison.reset();
  diagnosis.reset();
  ladder.clear();
}

void Session::Impl::drop_from_frfs() {
  if (ground) waiting = stack->history();
  ground.reset();
  stack.reset();
  plain.reset();
  base_comparison.reset();
  drop_current();
}

void Session::Impl::stack_waiting(const Progress& progress) {
  try {
    stack->restore(waiting, stack_fit(), progress);
  } catch (...) {
    // As if nothing had been prepared: the next call tries again.
    ground.reset();
    stack.reset();
    throw;
  }
}

void Session::overrule_hit(std::size_t run, std::size_t hit) {
  if (impl_->test.overrule({run, hit})) impl_->drop_from_frfs();
}

void Session::Impl::change_modes(const ModeChoices& choices,
                                 const Progress& progress) {
  // Modes that are the measurement are compared with those paired by hand.
  if (test.choose(choices, progress) || test.bundle().modes) {
    return drop_from_frfs();
  }
  base_comparison.reset();
  comparison.reset();
}

bool Session::Impl::move_choices(std::vector<ModeChoices>& from,
                                 std::vector<ModeChoices>& to,
                                 const Progress& progress) {
  if (from.empty()) return false;
  const ModeChoices now = test.choices();
  change_modes(from.back(), progress);
  from.pop_back();
  to.push_back(now);
  return true;
}

void Session::choose_modes(const ModeChoices& choices,
                           const Progress& progress) {
  const ModeChoices before = mode_choices();
  if (choices == before) return;
  impl_->change_modes(choices, progress);
  impl_->past_choices.push_back(before);
  impl_->future_choices.clear();
}

const ModeChoices& Session::mode_choices() const {
  return impl_->test.choices();
}

bool Session::undo_modes(const Progress& progress) {
  return impl_->move_choices(
      impl_->past_choices, impl_->future_choices, progress);
}

bool Session::redo_modes(const Progress& progress) {
  return impl_->move_choices(
      impl_->future_choices, impl_->past_choices, progress);
}

void Session::add_together(const std::vector<EffectRef>& effects,
                           const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  if (bundle().modes) check_shown_in_modes(effects);
  impl_->stack->add_together(effects, impl_->stack_fit(), progress);
  impl_->drop_current();
}

void Session::toggle(std::size_t effect, const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  impl_->stack->toggle(effect, impl_->stack_fit(), progress);
  impl_->drop_current();
}

void Session::fit_uncertain(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  impl_->stack->fit_uncertain(impl_->stack_fit(), progress);
  impl_->drop_current();
}

bool Session::undo(const Progress& progress) {
  if (!impl_->ground && impl_->waiting.now.empty()) return false;
  impl_->prepare_fit(*this, progress);
  if (!impl_->stack->undo(impl_->stack_fit(), progress)) return false;
  impl_->drop_current();
  return true;
}

bool Session::redo(const Progress& progress) {
  if (!impl_->ground && impl_->waiting.future.empty()) return false;
  impl_->prepare_fit(*this, progress);
  if (!impl_->stack->redo(impl_->stack_fit(), progress)) return false;
  impl_->drop_current();
  return true;
}

std::vector<AddedEffect> Session::effects() const {
  return impl_->ground ? impl_->stack->effects() : impl_->waiting.now;
}

const std::vector<OverruledHit>& Session::overruled() const {
  return impl_->test.overruled();
}

SavedSession Session::saved(const Progress& progress) {
  SavedSession result;
  result.title = bundle().title;
  result.overruled = overruled();
  result.modes = mode_choices();
  result.effects = effects();
  const EffectHistory& history =
      impl_->ground ? impl_->stack->history() : impl_->waiting;
  result.undone = changes_through(history.now, history.future);
  result.kept = history.kept;
  if (!impl_->ground) return result;
  for (const Rung& rung : ladder(progress)) {
    const Fit& fit = impl_->stack->fits()[result.ladder.size()];
    result.ladder.push_back({rung, impl_->compare_now(fit).pairs});
  }
  return result;
}

void Session::take_up(const SavedSession& saved) {
  if (bundle().modes) check_saved_shown_in_modes(saved);
  impl_->test.set_overruled(overruled_now(saved.overruled));
  impl_->test.set_choices(saved.modes);
  impl_->waiting.now = saved.effects;
  impl_->waiting.future = states_through(saved.effects, saved.undone);
  impl_->waiting.kept = saved.kept;
}

void Session::set_update(const UpdateChoice& choice) {
  if (bundle().modes) check_choice_for_modes(choice);
  if (const auto& band = bundle().band_hz) check_lines(choice.lines, *band);
  impl_->choice = choice;
  impl_->plain.reset();
}

std::vector<UpdateRecord> Session::update_records(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return records_of(
      impl_->stack->fits(),
      impl_->setting(),
      impl_->ground->properties,
      impl_->plain ? impl_->plain->lines : impl_->ground->contour);
}

std::vector<std::string> Session::model_warnings(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  std::vector<std::string> warnings = impl_->model->unsplit().warnings();
  warnings.push_back(floor_warning(base_comparison(progress)));
  warnings.push_back(base_error_warning(impl_->model->builder.error()));
  std::erase(warnings, "");
  if (bundle().modes) {
    std::ranges::copy(impl_->ground->fitter->setting().measured.statements,
                      std::back_inserter(warnings));
  }
  return warnings;
}

double Session::base_error(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return impl_->model->builder.error();
}

const std::vector<Rung>& Session::ladder(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  if (impl_->ladder.empty()) {
    impl_->ladder = rungs_of(impl_->stack->fits(), impl_->setting());
  }
  return impl_->ladder;
}

std::vector<Estimate> Session::model_parameters(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return all_estimates(
      impl_->current(), impl_->ground->properties, impl_->setting());
}

std::vector<ModelForm> Session::model_form(const Progress& progress) {
  impl_->prepare_fit(*this, progress);
  return updating::model_form(impl_->current(), deck(progress));
}

}  // namespace tapfit::updating
