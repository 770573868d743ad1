#include "updating/session/session_stages.hpp"

#include "updating/comparison/compare.hpp"
#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/likeliest_fit.hpp"
#include "updating/diagnosis/test_diagnosis.hpp"
#include "updating/measurement/test_model.hpp"
#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace tapfit::updating {

const structure::Deck& SessionStages::read_model(const Progress& progress) {
  if (deck) return *deck;
  progress("model: reading", 0.0);
  deck = read_test_model(test.bundle());
  return *deck;
}

effects::TestContext SessionStages::context() const {
  effects::TestContext s;
  s.bundle = &test.bundle();
  s.deck = &*deck;
  s.mass_kg = model->builder.mass_kg();
  s.low_hz = test.band()[0];
  s.high_hz = test.band()[1];
  s.component = measured_component(test.bundle(), *deck);
  s.components = tested_components(test.bundle(), *deck);
  return s;
}

void SessionStages::prepare_fit(const Progress& progress) {
  if (ground) return;
  const structure::Deck& the_deck = read_model(progress);
  static_cast<void>(test.modes(progress));
  if (!model) {
    model = solve_model(the_deck, test.bundle(), test.band()[1], progress);
  }
  ground = prepare_fits(*model, measured(), progress);
  stack.emplace(ground->base, !test.bundle().uncertain.empty());
  stack_waiting(progress);
}

MeasuredTest SessionStages::measured() {
  return {context(), test, test.frfs({}), test.modes({})};
}

StackFit SessionStages::stack_fit() {
  return {context(), std::bind_front(&SessionStages::fit_now, this)};
}

const FitContext& SessionStages::ground_of(
    const std::vector<EffectInstance>& effects, const Progress& progress) {
  std::vector<EffectInstance> corrections = deck_corrections(effects);
  if (corrections.empty()) return *ground;
  const auto same = [&corrections](const auto& known) {
    return std::ranges::equal(
        known->corrections,
        corrections,
        [](const EffectInstance& a, const EffectInstance& b) {
          return a.effect == b.effect && a.where == b.where;
        });
  };
  const auto known = std::ranges::find_if(corrected, same);
  if (known != corrected.end()) return (*known)->ground;
  corrected.push_back(
      correct_model(measured(), std::move(corrections), progress));
  return corrected.back()->ground;
}

Fit SessionStages::fit_now(const std::vector<EffectInstance>& effects,
                           const Fit& before,
                           const Progress& progress) {
  const Fitter& fitter = *ground_of(effects, progress).fitter;
  const auto base = fitter.model_for(effects);
  // Of the same deck; of another it says nothing.
  const bool same =
      &ground_of(before.effects, progress) == &ground_of(effects, progress);
  if (!choice.is_plain()) {
    return fitter.settled(
        fitter.fit(effects, base, progress, same ? &before : nullptr),
        progress);
  }
  if (!plain) {
    plain = plain_task(
        choice,
        measured(),
        {fitter.target(), ground->contour, test.frfs({}).s.real().minCoeff()},
        progress);
  }
  return plain_fit(
      fitter, *plain, effects, fitter.with_coarser(base, effects), before);
}

// Fits asked for in another way, and what is uncertain fitted before any
// effect, end elsewhere.
DiagnosisCache SessionStages::diagnosis_cache(std::size_t effects) {
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

const Fit& SessionStages::current_likeliest() {
  const bool fitted = stack->fits().size() > 1;
  if (choice.is_plain() || !fitted) return current();
  if (!likeliest) {
    const Fitter& fitter = *ground_now().fitter;
    const double data =
        independent_data(fitter.target(), current().result.residual);
    likeliest = likeliest_fit(current(), fitter, {data, ground->floor_noise});
  }
  return *likeliest;
}

Comparison SessionStages::compare_now(const Fit& fit) {
  const FitContext& own = ground_of(fit.effects);
  Comparison c = compare(fit,
                         own.fitter->target(),
                         test.frfs({}),
                         test.modes({}),
                         test.choices().pairs);
  c.floor_noise = own.floor_noise;
  c.floor_mesh = own.floor_mesh;
  c.floor_form = form_share(fit, own.fitter->target(), c.floor_noise).error;
  c.floor = std::hypot(c.floor_noise, c.floor_mesh, c.floor_form);
  c.contour = own.contour;
  return c;
}

void SessionStages::take_floor(const Diagnosis& of, const Progress& progress) {
  form_error = std::min(form_error.value_or(of.form_error), of.form_error);
  auto corrections = cut_at_deck(of, context()).corrections;
  if (!corrections.empty()) put_right = std::move(corrections);
  if (comparison) limit_floor(*comparison, progress);
}

void SessionStages::limit_floor(Comparison& now, const Progress& progress) {
  // A deck that is known to be wrong has the floor of another structure.
  if (!put_right.empty() && deck_corrections(current().effects).empty()) {
    const FitContext& right = ground_of(put_right, progress);
    now.floor_noise = right.floor_noise;
    now.floor_mesh = right.floor_mesh;
  }
  if (form_error) limit_form(now, *form_error);
}

void SessionStages::drop_current() {
  comparison.reset();
  diagnosis.reset();
  ladder.clear();
  likeliest.reset();
  tried.reset();
}

void SessionStages::drop_from_frfs() {
  if (ground) waiting = stack->history();
  ground.reset();
  stack.reset();
  corrected.clear();
  plain.reset();
  base_comparison.reset();
  form_error.reset();
  put_right.clear();
  drop_current();
}

void SessionStages::stack_waiting(const Progress& progress) {
  try {
    stack->restore(waiting, stack_fit(), progress);
  } catch (...) {
    // As if nothing had been prepared: the next call tries again.
    ground.reset();
    stack.reset();
    corrected.clear();
    throw;
  }
}

void SessionStages::change_modes(const ModeChoices& choices,
                                 const Progress& progress) {
  // Modes that are the measurement are compared with those paired by hand.
  if (test.choose(choices, progress) || test.bundle().modes) {
    return drop_from_frfs();
  }
  base_comparison.reset();
  comparison.reset();
}

bool SessionStages::move_choices(std::vector<ModeChoices>& from,
                                 std::vector<ModeChoices>& to,
                                 const Progress& progress) {
  if (from.empty()) return false;
  const ModeChoices now = test.choices();
  change_modes(from.back(), progress);
  from.pop_back();
  to.push_back(now);
  return true;
}

}  // namespace tapfit::updating
