#include "updating/session/find_evidence.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <algorithm>
#include <cstddef>

namespace tapfit::updating {
namespace {

/// The model with those added; what was added last is kept, since each of them
/// is asked for in turn.
EffectStack stack_with(SessionStages& stages,
                       const std::vector<EffectRef>& added,
                       const Progress& progress) {
  if (added.empty()) return *stages.stack;
  if (!stages.tried || stages.tried->added != added) {
    EffectStack stack = *stages.stack;
    stack.add_together(added, stages.stack_fit(), progress);
    stages.tried = TriedStack{added, std::move(stack)};
  }
  return stages.tried->stack;
}

std::size_t position_of(const EffectStack& stack, const EffectRef& effect) {
  const auto at = std::ranges::find(stack.effects(), effect, &AddedEffect::ref);
  if (at == stack.effects().end()) {
    throw InputError("the effect is not in the model",
                     effect_text(effect.effect, effect.where),
                     "add it first");
  }
  return static_cast<std::size_t>(at - stack.effects().begin());
}

/// The last fit that holds no effect.
const Fit& without_effects(const EffectStack& stack) {
  const std::vector<Fit>& fits = stack.fits();
  return *std::find_if(fits.rbegin(), fits.rend(), [](const Fit& fit) {
    return fit.effects.empty();
  });
}

}  // namespace

EffectEvidence find_evidence(SessionStages& stages,
                             const EffectRef& effect,
                             const std::vector<EffectRef>& added,
                             const Progress& progress) {
  EffectStack stack = stack_with(stages, added, progress);
  if (effect.effect == uncertain_rung) {
    return effect_evidence(stages.compare_now(stack.fits().front()),
                           stages.compare_now(without_effects(stack)));
  }
  const std::size_t own = position_of(stack, effect);
  const StackFit how = stages.stack_fit();
  if (!stack.effects()[own].on) stack.toggle(own, how, progress);
  const Comparison with = stages.compare_now(stack.fits().back());
  if (stack.fits().back().effects.size() == 1) {
    return effect_evidence(stages.compare_now(without_effects(stack)), with);
  }
  stack.toggle(own, how, progress);
  return effect_evidence(stages.compare_now(stack.fits().back()), with);
}

}  // namespace tapfit::updating
