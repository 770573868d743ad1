#include "updating/search/worth_fitting.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/places/held_support.hpp"
#include "updating/places/near_places.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tapfit::updating {
namespace {

constexpr std::size_t few_places = 8;
// A screened error of one that takes a base of its own for each of its forms,
// times that of the best of all.
constexpr double rival_error = 4.0;

bool has_form(const EffectInstance& placed) {
  const std::vector<std::string> forms = placed.effect->forms();
  return std::ranges::find(forms, placed.where.variant) != forms.end();
}

// At the same grid, but for being between it and the next.
bool is_beside(const Location& one, const Location& other) {
  return is_at_grid(one) && one.node == other.node &&
         one.variant == other.variant && one.at != other.at;
}

// A point of the sheet is put right once.
bool is_same_point(const Location& one, const Location& other) {
  return share(one.channels, other.channels) &&
         (one.nodes.empty() || other.nodes.empty() ||
          one.nodes == other.nodes) &&
         (one.runs.empty() || other.runs.empty() ||
          share(one.runs, other.runs));
}

}  // namespace

bool is_present(const Fit& current, const EffectInstance& candidate) {
  const Location& there = candidate.where;
  return std::ranges::any_of(current.effects, [&](const EffectInstance& e) {
    if (e.effect != candidate.effect) return false;
    const bool formed = has_form(e) || has_form(candidate);
    if (e.effect->at_sheet_points()) return is_same_point(e.where, there);
    return e.where == there || share(e.where.elements, there.elements) ||
           (formed && (share(e.where.nodes, there.nodes) ||
                       share(e.where.channels, there.channels) ||
                       (e.where.node != 0 && e.where.node == there.node))) ||
           is_beside(e.where, there);
  });
}

namespace {

// What is worth a full fit of one kind: its best screened places, apart from
// each other where a climb goes on from them, or all where it is not screened.
std::vector<EffectInstance> worth_fitting(const effects::Effect& effect,
                                          const Fit& current,
                                          const std::vector<Screened>& screened,
                                          const Fitter& fitter,
                                          const HypothesisOptions& options,
                                          const Reach& reach) {
  const effects::TestContext& context = fitter.problem().context;
  std::vector<EffectInstance> tries;
  // Sensors and channels are few and each differs from the others. Their
  // screening is exact but for what the rest may give way. They share a base;
  // what changes the stiffness takes one each, and all are looked at once.
  const bool few = fitter.places(effect).size() <= few_places &&
                   (options.places_per_kind > 1 || !effect.changes_stiffness());
  const int most_places =
      effect.changes_stiffness() == ChangeKind::Joint
          ? std::max(options.places_per_kind, options.joints)
          : options.places_per_kind;
  // A support that the structure has not, or one that the model has not.
  const bool support = effect.is_mistake() && effect.changes_stiffness();
  const auto is_new = [&](const Screened& s) {
    const bool climbs = !effect.at_sheet_points() && !support;
    const bool known =
        !few && climbs && options.neighbours > 0 &&
        std::ranges::any_of(tries, [&](const EffectInstance& other) {
          return within_reach(other.where,
                              s.placed.where,
                              fitter.places(effect),
                              *context.deck,
                              options.neighbours);
        });
    const bool twice = std::ranges::any_of(tries, [&](const EffectInstance& p) {
      return p.where == s.placed.where;
    });
    return !known && !twice && !is_present(current, s.placed);
  };
  const bool is_preload = effect.changes_stiffness() == ChangeKind::Preload;
  const Screened* likely = nullptr;
  for (const Screened& s : screened) {
    if (s.placed.effect != &effect) continue;
    if (likely == nullptr || s.any_law < likely->any_law) likely = &s;
  }
  for (const Screened& s : screened) {
    if (s.placed.effect != &effect) continue;
    const auto count = static_cast<int>(tries.size());
    if (!few && count == most_places) break;
    // A tight wire is far from small, and its first order tells little.
    const bool promising =
        s.error <= options.promising * screened.front().error &&
        s.error <= reach.hopeless_screened_error();
    if (!promising && !(few && is_preload)) break;
    const bool held = is_held(s.placed.where);
    if (held && s.error > rival_error * screened.front().error) break;
    if (is_new(s)) tries.push_back(s.placed);
  }
  // The grid that explains most whatever the law: sizes far from the model's
  // are screened too coarsely to be told by them.
  if (likely != nullptr && likely->any_law > 0.0 && options.neighbours > 0 &&
      is_new(*likely)) {
    tries.push_back(likely->placed);
  }
  if ((likely != nullptr && !support) || effect.at_sheet_points()) return tries;
  // A support that the structure has not is no small thing, and takes a base of
  // its own for each of its forms: looked for where all is looked at.
  if (support && options.places_per_kind <= 1) return tries;
  for (const Location& where : fitter.places(effect)) {
    if (support && is_held(where)) continue;  // screened
    const EffectInstance p = placed(effect, where, context);
    if (!is_present(current, p)) tries.push_back(p);
  }
  return tries;
}

}  // namespace

std::vector<Planned> planned_fits(const Fit& current,
                                  const std::vector<Screened>& screened,
                                  const Fitter& fitter,
                                  const HypothesisOptions& options,
                                  const Reach& reach) {
  std::vector<Planned> result;
  for (const effects::Effect* effect : effects::catalogue()) {
    // A ratio for each mode is fitted along: a law explains no more. Another
    // deck is looked for besides.
    if (effect->entry() == effects::Entry::Damping) continue;
    if (effect->corrects_deck()) continue;
    Planned plan;
    plan.effect = effect;
    plan.tries =
        worth_fitting(*effect, current, screened, fitter, options, reach);
    const Fit* known = options.known;
    if (known != nullptr && known->effects.back().effect == effect) {
      plan.known = known;
      std::erase_if(plan.tries, [known](const EffectInstance& e) {
        return e.where == known->effects.back().where;
      });
    }
    const bool any = !plan.tries.empty() || plan.known != nullptr;
    if (any) result.push_back(std::move(plan));
  }
  return result;
}

}  // namespace tapfit::updating
