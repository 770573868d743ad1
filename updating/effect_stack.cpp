#include "updating/effect_stack.hpp"

#include "acquisition/input_error.hpp"
#include "updating/effect_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tapfit::updating {
namespace {

bool same_place(const PlacedEffect& a, const PlacedEffect& b) {
  return a.effect == b.effect && a.where == b.where;
}

// Says so where a fit leaves as much as the one before it.
Fit judged(Fit fit, const Fit& before) {
  if (!(fit.result.error < before.result.error)) {
    fit.result.message +=
        ", but the error does not fall: the data do not ask for it";
  }
  return fit;
}

}  // namespace

EffectStack::EffectStack(Fit base, bool uncertain) : uncertain_(uncertain) {
  fits_.push_back(std::move(base));
}

void EffectStack::fit_uncertain(const StackFit& how, const Progress& progress) {
  if (fits_.size() > 1) return;
  fits_.push_back(judged(how.fit({}, progress), fits_.front()));
}

// Fits that stay true are kept: up to the first effect that differs.
std::vector<Fit> EffectStack::fits_for(const std::vector<PlacedEffect>& wanted,
                                       const StackFit& how,
                                       const Progress& progress) const {
  std::vector<Fit> fits = {fits_.front()};
  if (wanted.empty()) return fits;
  const bool fitted = fits_.size() > 1 && fits_[1].effects.empty();
  const std::size_t first_effect = fitted ? 2 : 1;
  if (fitted) {
    fits.push_back(fits_[1]);
  } else if (uncertain_) {
    fits.push_back(judged(how.fit({}, progress), fits.front()));
  }
  bool same = true;
  std::vector<PlacedEffect> so_far;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const std::size_t at = first_effect + k;
    same = same && at < fits_.size() && fits_[at].effects.size() == k + 1 &&
           same_place(fits_[at].effects[k], wanted[k]);
    if (same) {
      fits.push_back(fits_[at]);
    } else {
      so_far.push_back(wanted[k]);
      fits.push_back(judged(how.fit(so_far, progress), fits.back()));
    }
    so_far = fits.back().effects;
  }
  return fits;
}

void EffectStack::change_to(const Effects& effects,
                            const StackFit& how,
                            const Progress& progress) {
  std::vector<PlacedEffect> on;
  for (const AddedEffect& added : effects) {
    if (!added.on) continue;
    on.push_back(place_effect(added.ref, how.setting));
  }
  fits_ = fits_for(on, how, progress);
  effects_ = effects;
}

void EffectStack::add(const EffectRef& effect,
                      const StackFit& how,
                      const Progress& progress) {
  const PlacedEffect extra = place_effect(effect, how.setting);
  const EffectRef whole{extra.effect->name(), extra.where};
  for (const AddedEffect& known : effects_) {
    if (known.ref != whole) continue;
    throw InputError(
        "the effect is in the model already",
        fmt::format("{} at {}", whole.effect, describe(whole.where)),
        known.on ? "undo it first, or add another"
                 : "it is switched off: switch it on, or add another");
  }
  Effects more = effects_;
  more.push_back({whole, true});
  const Effects before = effects_;
  change_to(more, how, progress);
  past_.push_back(before);
  future_.clear();
}

void EffectStack::toggle(std::size_t effect,
                         const StackFit& how,
                         const Progress& progress) {
  if (effect >= effects_.size()) {
    throw InputError(fmt::format("there is no effect {} to switch", effect + 1),
                     "model",
                     effects_.empty()
                         ? std::string("none was added yet")
                         : fmt::format("1 to {} were added", effects_.size()));
  }
  const Effects before = effects_;
  Effects other = effects_;
  other[effect].on = !other[effect].on;
  change_to(other, how, progress);
  past_.push_back(before);
  future_.clear();
}

bool EffectStack::undo(const StackFit& how, const Progress& progress) {
  if (past_.empty()) return false;
  const Effects now = effects_;
  change_to(past_.back(), how, progress);
  past_.pop_back();
  future_.push_back(now);
  return true;
}

bool EffectStack::redo(const StackFit& how, const Progress& progress) {
  if (future_.empty()) return false;
  const Effects now = effects_;
  change_to(future_.back(), how, progress);
  future_.pop_back();
  past_.push_back(now);
  return true;
}

}  // namespace tapfit::updating
