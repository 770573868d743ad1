#include "updating/search/climb.hpp"

#include "updating/places/crack_line.hpp"
#include "updating/places/near_places.hpp"
#include "updating/places/stretched_patches.hpp"
#include "updating/search/fit_each.hpp"
#include "updating/search/screening.hpp"
#include "updating/search/worth_fitting.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace tapfit::updating {

namespace {

// A climb goes on while it gains: across a structure if need be.
constexpr int most_steps = 40;
/// The neighbours of a place.
using Near = std::function<std::vector<Location>(const Location&)>;

/// Whether one is better than another.
using Better = bool (*)(const Hypothesis&, const Hypothesis&);

// Around the best place of a kind, step to a better neighbour until there is
// none, or the way is too long. Each step fits all neighbours, grids in one
// base.
void climb(std::vector<Hypothesis>& found,
           Better better,
           const Fit& current,
           const Fitter& fitter,
           const Near& near,
           Reach& reach,
           const Progress& progress) {
  std::vector<Location> seen;
  for (const Hypothesis& h : found) seen.push_back(h.own().where);
  for (int round = 0; round < most_steps; ++round) {
    const Hypothesis best =
        *std::min_element(found.begin(), found.end(), better);
    const EffectInstance& own = best.own();
    std::vector<EffectInstance> tries;
    for (const Location& where : near(own.where)) {
      if (std::find(seen.begin(), seen.end(), where) != seen.end()) continue;
      seen.push_back(where);
      EffectInstance next =
          placed(*own.effect, where, fitter.problem().context);
      if (next.p.size() == own.p.size()) next.p = own.p;
      if (!is_present(current, next)) tries.push_back(next);
    }
    if (tries.empty()) return;
    const std::shared_ptr<const FrfModel> shared =
        own.effect->changes_stiffness() ? nullptr
                                        : shared_base(current, tries, fitter);
    const Hypothesis before = *std::ranges::min_element(found, is_likelier);
    bool gained = false;
    for (Hypothesis& h : fit_each_beside(
             best.fit, current, tries, fitter, shared, reach, progress)) {
      gained = gained || better(h, best);
      reach.take(h);
      found.push_back(std::move(h));
    }
    const Hypothesis& now = *std::ranges::min_element(found, is_likelier);
    const int left = most_steps - round - 1;
    if (!gained || !reach.holds_way(before, now, left)) return;
  }
}

}  // namespace

void look_elsewhere(std::vector<Hypothesis>& found,
                    const Fit& current,
                    const Fitter& fitter,
                    int neighbours,
                    Reach& reach,
                    const Progress& progress) {
  constexpr int most_turns = 4;
  constexpr std::size_t places_a_turn = 4;
  // Times the least screened error: what a fit may mend of it.
  constexpr double may_be_better = 1.3;
  const structure::Deck& deck = *fitter.problem().context.deck;
  for (int turn = 0; turn < most_turns; ++turn) {
    const Hypothesis best = *std::ranges::min_element(found, is_likelier);
    const std::vector<Location>& all = fitter.places(*best.own().effect);
    std::vector<Location> seen;
    for (const Hypothesis& h : found) seen.push_back(h.own().where);
    std::vector<EffectInstance> tries;
    const std::vector<Screened> screened =
        screen_elsewhere(current, best.fit, fitter, progress);
    for (const Screened& s : screened) {
      if (s.error > may_be_better * screened.front().error) break;
      const Location& where = s.placed.where;
      const bool known = std::ranges::any_of(seen, [&](const Location& other) {
        return within_reach(other, where, all, deck, neighbours);
      });
      if (known || is_present(current, s.placed)) continue;
      seen.push_back(where);
      tries.push_back(s.placed);
      if (tries.size() == places_a_turn) break;
    }
    if (tries.empty()) return;
    bool gained = false;
    for (Hypothesis& h : fit_each_beside(best.fit,
                                         current,
                                         tries,
                                         fitter,
                                         shared_base(current, tries, fitter),
                                         reach,
                                         progress)) {
      gained = gained || is_likelier(h, best);
      reach.take(h);
      found.push_back(std::move(h));
    }
    if (!gained) return;
  }
}

void climb_places(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  int neighbours,
                  Reach& reach,
                  const Progress& progress) {
  const effects::TestContext& context = fitter.problem().context;
  const EffectInstance& any = found.front().own();
  const bool is_loss = any.effect->changes_stiffness() == ChangeKind::Elements;
  const std::vector<Location>& all = fitter.places(*any.effect);
  const auto near = [&](const Location& at) {
    std::vector<Location> places =
        places_near(at, all, *context.deck, neighbours);
    for (Location& where : places) {
      if (is_loss) where.variant = at.variant;
    }
    return places;
  };
  climb(found, is_likelier, current, fitter, near, reach, progress);
}

void climb_shapes(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  Reach& reach,
                  const Progress& progress) {
  const structure::Deck& deck = *fitter.problem().context.deck;
  const auto near = [&deck](const Location& at) {
    std::vector<Location> places;
    for (std::vector<int>& ids : stretched_patches(at.elements, deck)) {
      places.push_back(at);
      places.back().elements = std::move(ids);
    }
    return places;
  };
  climb(found, less_error, current, fitter, near, reach, progress);
}

void climb_cracks(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  Reach& reach,
                  const Progress& progress) {
  const structure::Deck& deck = *fitter.problem().context.deck;
  const auto near = [&deck](const Location& at) {
    std::vector<Location> places;
    for (std::vector<int>& nodes : cracks_near(deck, at.nodes)) {
      if (crack_line(deck, nodes).grids.empty()) continue;
      places.push_back(at);
      places.back().nodes = std::move(nodes);
    }
    return places;
  };
  climb(found, less_error, current, fitter, near, reach, progress);
}

}  // namespace tapfit::updating
