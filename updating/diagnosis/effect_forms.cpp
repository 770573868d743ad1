#include "updating/diagnosis/effect_forms.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/effects/effect_instance.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

// The whole with the sizes that its parts have, by their names.
EffectInstance with_sizes_of(std::initializer_list<const EffectInstance*> parts,
                             EffectInstance whole,
                             const effects::TestContext& context) {
  std::map<std::string, double> sizes;
  for (const EffectInstance* part : parts) {
    const auto specs = part->effect->parameters(part->where, context);
    for (std::size_t k = 0; k < specs.size(); ++k) {
      sizes[specs[k].name] = part->p[k];
    }
  }
  const auto specs = whole.effect->parameters(whole.where, context);
  for (std::size_t k = 0; k < specs.size(); ++k) {
    const auto known = sizes.find(specs[k].name);
    if (known != sizes.end()) whole.p[k] = known->second;
  }
  return whole;
}

bool is_form(const EffectInstance& own) {
  const std::vector<std::string>& forms = own.effect->forms();
  return std::ranges::find(forms, own.where.variant) != forms.end();
}

// What it is without its form, of each kind that there is at its place.
std::vector<EffectInstance> plain_ones(const EffectInstance& own,
                                       const effects::TestContext& context) {
  std::vector<EffectInstance> plain;
  for (const Location& place : own.effect->places(context)) {
    Location formed = place;
    formed.variant = own.where.variant;
    if (formed != own.where) continue;
    plain.push_back(
        with_sizes_of({&own}, placed(*own.effect, place, context), context));
  }
  return plain;
}

}  // namespace

std::optional<EffectInstance> both_of(const EffectInstance& one,
                                      const EffectInstance& other,
                                      const effects::TestContext& context) {
  const effects::Effect& effect = *one.effect;
  const bool support = effect.changes_stiffness() == ChangeKind::Support &&
                       one.effect == other.effect &&
                       one.where.nodes == other.where.nodes;
  Location where = one.where;
  where.variant = "both";
  if (!support || !effect.takes(where.variant, one.where, context)) {
    return std::nullopt;
  }
  return with_sizes_of({&one, &other}, placed(effect, where, context), context);
}

std::optional<Fit> in_plain_form(const Fit& fit,
                                 std::size_t k,
                                 const Fitter& fitter,
                                 const Progress& progress) {
  // Of log likelihood: less is the plain one under another name.
  constexpr double clearly = 1.0;
  const EffectInstance& own = fit.effects[k];
  if (!is_form(own)) return std::nullopt;
  const std::vector<EffectInstance> plain =
      plain_ones(own, fitter.problem().context);
  std::vector<Fit> fits(plain.size());
  const Progress quiet{{}, progress.stop};
  for_each_parallel(plain.size(), [&](std::size_t n) {
    std::vector<EffectInstance> effects = fit.effects;
    effects[k] = plain[n];
    fits[n] = fitter.fit(effects, fitter.model_for(effects), quiet);
  });
  std::optional<Fit> best;
  for (Fit& other : fits) {
    const double least =
        best ? best->log_likelihood : fit.log_likelihood - clearly;
    if (other.log_likelihood > least) best = std::move(other);
  }
  return best;
}

}  // namespace tapfit::updating
