#include "updating/diagnosis/effect_forms.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/effects/effect_instance.hpp"
#include "updating/set_up/mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <set>
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

std::set<std::string> channels_of(
    std::initializer_list<const EffectInstance*> parts) {
  std::set<std::string> channels;
  for (const EffectInstance* part : parts) {
    channels.insert(part->where.channels.begin(), part->where.channels.end());
  }
  return channels;
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

// Of a channel's gain the nearest that a unit explains.
std::optional<EffectInstance> unit_of(const EffectInstance& own,
                                      const effects::TestContext& context) {
  const effects::Effect& unit = effects::unit_factor();
  std::optional<EffectInstance> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const Location& place : unit.places(context)) {
    const std::vector<effects::Effect::Fixed> size = unit.fixed(place);
    const bool same = place.channels == own.where.channels;
    if (!same || !place.runs.empty() || size.empty()) continue;
    const double off = std::abs(std::log(own.p.front() / size.front().value));
    if (off >= least) continue;
    least = off;
    nearest = placed(unit, place, context);
  }
  return nearest;
}

}  // namespace

std::vector<EffectInstance> both_of(const EffectInstance& one,
                                    const EffectInstance& other,
                                    const effects::TestContext& context) {
  if (one.effect != other.effect) return {};
  const effects::Effect& effect = *one.effect;
  const auto as_whole = [&](const Location& where) {
    return with_sizes_of(
        {&one, &other}, placed(effect, where, context), context);
  };
  Location where = one.where;
  where.variant = "both";
  if (effect.changes_stiffness() == ChangeKind::Support &&
      one.where.nodes == other.where.nodes &&
      effect.takes(where.variant, one.where, context)) {
    return {as_whole(where)};
  }
  const std::set<std::string> channels = channels_of({&one, &other});
  std::vector<EffectInstance> whole;
  for (Location place : effect.places(context)) {
    if (channels.size() < 2 ||
        std::set(place.channels.begin(), place.channels.end()) != channels) {
      continue;
    }
    whole.push_back(as_whole(place));
    if (!effect.takes("each", place, context)) continue;
    place.variant = "each";
    whole.push_back(as_whole(place));
  }
  return whole;
}

std::optional<Fit> in_plain_form(const Fit& fit,
                                 std::size_t k,
                                 const Fitter& fitter,
                                 const Progress& progress) {
  // Of log likelihood: less is the plain one under another name.
  constexpr double clearly = 1.0;
  const EffectInstance& own = fit.effects[k];
  const effects::TestContext& context = fitter.problem().context;
  std::vector<EffectInstance> plain;
  if (is_form(own)) plain = plain_ones(own, context);
  if (own.effect == &effects::channel_gain()) {
    if (auto unit = unit_of(own, context)) plain.push_back(*std::move(unit));
  }
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
