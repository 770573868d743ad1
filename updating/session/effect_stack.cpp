#include "updating/session/effect_stack.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/fit/fit_observer.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/effect_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace tapfit::updating {
namespace {

bool same_place(const EffectInstance& a, const EffectInstance& b) {
  return a.effect == b.effect && a.where == b.where;
}

// Says so where a fit leaves as much as the one before it, or more: a law for
// the damping takes the place of a ratio for each mode.
Fit judged(Fit fit, const Fit& before) {
  constexpr double noticeable = 1e-3;
  if (fit.result.error > (1.0 + noticeable) * before.result.error) {
    fit.result.message +=
        fmt::format("; the error rises from {:.3g} % to {:.3g} %: leave it out",
                    100.0 * before.result.error,
                    100.0 * fit.result.error);
  } else if (!(fit.result.error < before.result.error)) {
    fit.result.message += "; the error does not fall";
    if (fit.result.converged) {
      fit.result.message += ": the data do not ask for it";
    }
  }
  return fit;
}

/// Where its fits start: as it was found, or as its kind does.
EffectInstance started(const EffectRef& ref, const StackFit& how) {
  EffectInstance effect = place_effect(ref, how.context);
  effect.place_sd = ref.place_sd;
  if (ref.start.size() == effect.p.size()) effect.p = ref.start;
  return effect;
}

std::vector<EffectRef> refs_of(const std::vector<EffectInstance>& effects) {
  std::vector<EffectRef> refs;
  for (const EffectInstance& e : effects) {
    refs.push_back({e.effect->name(), e.where});
  }
  return refs;
}

/// To its end, or to where it was kept.
Fit fit_of(const std::vector<EffectInstance>& effects,
           const Fit& before,
           std::vector<EarlyStoppedFit>& kept,
           const StackFit& how,
           const Progress& progress) {
  const std::vector<EffectRef> refs = refs_of(effects);
  const auto known = std::ranges::find(kept, refs, &EarlyStoppedFit::effects);
  Fit fit = fit_until_stopped(
      [&](const Progress& watched) {
        return how.fit(effects, before, watched);
      },
      known == kept.end() ? 0 : known->steps,
      progress);
  if (fit.stopped_after > 0) {
    if (known != kept.end()) kept.erase(known);
    kept.push_back({refs, fit.stopped_after});
  }
  return judged(std::move(fit), before);
}

/// Whether that fit is one of those that lead to these effects.
bool leads_to(const EarlyStoppedFit& fit,
              const EffectHistory::Effects& effects) {
  std::vector<EffectRef> on;
  for (const AddedEffect& added : effects) {
    if (added.on) on.push_back(added.ref);
  }
  return !on.empty() && fit.effects.size() <= on.size() &&
         std::equal(fit.effects.begin(), fit.effects.end(), on.begin());
}

/// The effect with the whole place it acts at.
EffectRef whole_of(const EffectRef& effect, const StackFit& how) {
  const EffectInstance placed = place_effect(effect, how.context);
  return {placed.effect->name(), placed.where, effect.place_sd, effect.start};
}

/// @throws InputError where it is among those that are there already
void refuse_known(const EffectRef& whole,
                  const std::vector<AddedEffect>& there) {
  for (const AddedEffect& known : there) {
    if (known.ref != whole) continue;
    throw InputError(
        "the effect is in the model already",
        fmt::format("{} at {}", whole.effect, describe(whole.where)),
        known.on ? "undo it first, or add another"
                 : "it is switched off: switch it on, or add another");
  }
}

/// "mass_kg" of "mass_kg.acc1".
std::string stem_of(const effects::ParameterSpec& parameter) {
  return parameter.name.substr(0, parameter.name.find('.'));
}

/// Whether two are forms of one effect at one place, one of which can do what
/// the other does, or part of it: they would share a size in any way.
bool overlap(const EffectRef& a,
             const EffectRef& b,
             const effects::TestContext& context) {
  if (a.effect != b.effect || a.where.variant == b.where.variant) return false;
  Location there = b.where;
  there.variant = a.where.variant;
  if (there != a.where) return false;
  const effects::Effect& effect = effects::find(a.effect);
  const std::vector<std::string> forms = effect.forms();
  const bool plain = std::ranges::none_of(forms, [&](const auto& form) {
    return form == a.where.variant || form == b.where.variant;
  });
  if (plain) return false;
  const auto ours = effect.parameters(a.where, context);
  const auto theirs = effect.parameters(b.where, context);
  return std::ranges::any_of(ours, [&theirs](const auto& own) {
    return std::ranges::find(theirs, stem_of(own), stem_of) != theirs.end();
  });
}

/// Of effects that are to be added together.
/// @throws InputError where the last is one of those before it, or another form
///   of one
void refuse_conflict(const std::vector<EffectRef>& added, const StackFit& how) {
  const EffectRef& last = added.back();
  for (const EffectRef& other : std::span(added).first(added.size() - 1)) {
    if (other != last && !overlap(other, last, how.context)) continue;
    throw InputError(
        other == last ? "the effect is there twice"
                      : "two forms of one effect exclude each other",
        fmt::format("{} at {} and at {}",
                    last.effect,
                    describe(other.where),
                    describe(last.where)),
        other == last ? "name it once"
                      : "they would share one size: add one of them only");
  }
}

/// @throws InputError where another form of the effect is switched on
void refuse_overlap(const EffectHistory::Effects& effects,
                    std::size_t own,
                    const StackFit& how) {
  const EffectRef& ref = effects[own].ref;
  for (const AddedEffect& known : effects) {
    if (!known.on || !overlap(ref, known.ref, how.context)) continue;
    throw InputError(
        "another form of the effect is in the model already",
        fmt::format("{} at {}", ref.effect, describe(ref.where)),
        fmt::format("they would share one size in any way: first take out {} "
                    "at {}, or keep it and leave this one",
                    known.ref.effect,
                    describe(known.ref.where)));
  }
}

/// Each step added, and what of it is off at once switched off.
std::vector<EffectHistory::Effects> past_of(
    const std::vector<AddedEffect>& effects) {
  std::vector<EffectHistory::Effects> past;
  EffectHistory::Effects so_far;
  while (so_far.size() < effects.size()) {
    past.push_back(so_far);
    const std::size_t begin = so_far.size();
    do {
      so_far.push_back(effects[so_far.size()]);
      so_far.back().on = true;
    } while (so_far.size() < effects.size() && effects[so_far.size()].together);
    for (std::size_t k = begin; k < so_far.size(); ++k) {
      if (effects[k].on) continue;
      past.push_back(so_far);
      so_far[k].on = false;
    }
  }
  return past;
}

}  // namespace

EffectStack::EffectStack(Fit base, bool uncertain) : uncertain_(uncertain) {
  fits_.push_back(std::move(base));
}

void EffectStack::fit_uncertain(const StackFit& how, const Progress& progress) {
  if (fits_.size() > 1) return;
  fits_.push_back(fit_of({}, fits_.front(), history_.kept, how, progress));
}

// Fits that stay true are kept: up to the first effect that differs.
std::vector<Fit> EffectStack::fits_for(const std::vector<EffectRef>& wanted,
                                       std::vector<EarlyStoppedFit>& kept,
                                       const StackFit& how,
                                       const Progress& progress) const {
  std::vector<Fit> fits = {fits_.front()};
  if (wanted.empty()) return fits;
  // What is uncertain, then the effects.
  const auto part = [&](std::size_t k) {
    const auto begin = static_cast<double>(k);
    const auto count = static_cast<double>(wanted.size() + 1);
    return observed_part(progress, begin / count, (begin + 1.0) / count);
  };
  const bool fitted = fits_.size() > 1 && fits_[1].effects.empty();
  const std::size_t first_effect = fitted ? 2 : 1;
  if (fitted) {
    fits.push_back(fits_[1]);
  } else if (uncertain_) {
    fits.push_back(fit_of({}, fits.front(), kept, how, part(0)));
  }
  bool same = true;
  std::vector<EffectInstance> so_far;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const std::size_t at = first_effect + k;
    const EffectInstance next = started(wanted[k], how);
    same = same && at < fits_.size() && fits_[at].effects.size() == k + 1 &&
           same_place(fits_[at].effects[k], next);
    if (same) {
      fits.push_back(fits_[at]);
    } else {
      so_far.push_back(next);
      fits.push_back(fit_of(so_far, fits.back(), kept, how, part(k + 1)));
    }
    so_far = fits.back().effects;
    for (std::size_t j = 0; j <= k; ++j) {
      if (!wanted[j].start.empty()) so_far[j] = started(wanted[j], how);
    }
  }
  return fits;
}

void EffectStack::change_to(const Effects& effects,
                            std::vector<EarlyStoppedFit> kept,
                            const StackFit& how,
                            const Progress& progress) {
  std::vector<EffectRef> on;
  for (const AddedEffect& added : effects) {
    if (added.on) on.push_back(added.ref);
  }
  fits_ = fits_for(on, kept, how, progress);
  history_.now = effects;
  history_.kept = std::move(kept);
}

std::vector<EarlyStoppedFit> EffectStack::still_kept() const {
  std::vector<EarlyStoppedFit> kept = history_.kept;
  std::erase_if(kept, [this](const EarlyStoppedFit& fit) {
    const auto holds = [&fit](const Effects& e) { return leads_to(fit, e); };
    return !holds(history_.now) && std::ranges::none_of(history_.past, holds);
  });
  return kept;
}

void EffectStack::add_together(const std::vector<EffectRef>& effects,
                               const StackFit& how,
                               const Progress& progress) {
  if (effects.empty()) return;
  const Effects before = history_.now;
  std::vector<EffectRef> added;
  for (const EffectRef& effect : effects) {
    added.push_back(whole_of(effect, how));
    refuse_known(added.back(), before);
    refuse_conflict(added, how);
  }
  const Effects more = with_added(before, added);
  for (std::size_t k = before.size(); k < more.size(); ++k) {
    refuse_overlap(more, k, how);
  }
  change_to(more, still_kept(), how, progress);
  history_.past.push_back(before);
  history_.future.clear();
}

void EffectStack::restore(const EffectHistory& history,
                          const StackFit& how,
                          const Progress& progress) {
  Effects whole;
  for (const AddedEffect& added : history.now) {
    const EffectRef ref = whole_of(added.ref, how);
    refuse_known(ref, whole);
    whole.push_back({ref, added.on, added.together});
  }
  change_to(whole, history.kept, how, progress);
  history_.past = history.past;
  history_.future = history.future;
  if (history.past.empty()) history_.past = past_of(whole);
}

void EffectStack::toggle(std::size_t effect,
                         const StackFit& how,
                         const Progress& progress) {
  if (effect >= history_.now.size()) {
    throw InputError(fmt::format("there is no effect {} to switch", effect + 1),
                     "model",
                     history_.now.empty() ? std::string("none was added yet")
                                          : fmt::format("1 to {} were added",
                                                        history_.now.size()));
  }
  const Effects before = history_.now;
  Effects other = history_.now;
  other[effect].on = !other[effect].on;
  if (other[effect].on) refuse_overlap(other, effect, how);
  change_to(other, still_kept(), how, progress);
  history_.past.push_back(before);
  history_.future.clear();
}

bool EffectStack::undo(const StackFit& how, const Progress& progress) {
  if (history_.past.empty()) return false;
  const Effects now = history_.now;
  change_to(history_.past.back(), history_.kept, how, progress);
  history_.past.pop_back();
  history_.future.push_back(now);
  return true;
}

bool EffectStack::redo(const StackFit& how, const Progress& progress) {
  if (history_.future.empty()) return false;
  const Effects now = history_.now;
  change_to(history_.future.back(), history_.kept, how, progress);
  history_.future.pop_back();
  history_.past.push_back(now);
  return true;
}

}  // namespace tapfit::updating
