#include "updating/hypotheses.hpp"

#include "updating/effects/catalogue.hpp"
#include "updating/parallel.hpp"
#include "updating/screening.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace tapfit::updating {
namespace {

constexpr std::size_t few_places = 8;

bool share(const std::vector<int>& a, const std::vector<int>& b) {
  return std::any_of(a.begin(), a.end(), [&b](int id) {
    return std::find(b.begin(), b.end(), id) != b.end();
  });
}

// The same again, or another loss of the same elements.
bool present(const Fit& current, const PlacedEffect& candidate) {
  return std::any_of(
      current.effects.begin(),
      current.effects.end(),
      [&](const PlacedEffect& e) {
        return e.effect == candidate.effect &&
               (e.where == candidate.where ||
                share(e.where.elements, candidate.where.elements));
      });
}

// Grids nearest to a grid, itself first.
std::vector<int> nearest(const structure::Deck& deck, int node, int count) {
  const Eigen::Vector3d at = deck.grids[deck.grid_index(node)].position;
  std::vector<std::pair<double, int>> distance;
  for (const structure::Grid& grid : deck.grids) {
    distance.emplace_back((grid.position - at).norm(), grid.id);
  }
  const auto n = std::min<std::size_t>(distance.size(),
                                       static_cast<std::size_t>(count) + 1);
  std::partial_sort(distance.begin(),
                    distance.begin() + static_cast<std::ptrdiff_t>(n),
                    distance.end());
  std::vector<int> nodes;
  for (std::size_t k = 0; k < n; ++k) nodes.push_back(distance[k].second);
  return nodes;
}

// Fits the present effects and one more, for each of several.
//
// @param shared one base for all of them; empty: each gets its own
std::vector<Hypothesis> fit_each(const Fit& current,
                                 const std::vector<PlacedEffect>& extras,
                                 const Fitter& fitter,
                                 const std::shared_ptr<const FrfModel>& shared,
                                 const Progress& progress) {
  std::vector<Hypothesis> result(extras.size());
  // Only this thread reports; the others only listen for the stop.
  const Progress quiet{{}, progress.stop};
  for_each_parallel(extras.size(), [&](std::size_t k) {
    std::vector<PlacedEffect> effects = current.effects;
    effects.push_back(extras[k]);
    result[k].fit =
        fitter.fit(effects, shared ? shared : fitter.model_for(effects), quiet);
  });
  return result;
}

// Around the best place of a kind, step to a better neighbour until there is
// none. Each step fits all neighbours in one base.
void climb(std::vector<Hypothesis>& found,
           const Fit& current,
           const Fitter& fitter,
           int neighbours,
           const Progress& progress) {
  std::set<int> seen;
  for (const Hypothesis& h : found) seen.insert(h.own().where.node);
  for (int round = 0; round < 6; ++round) {
    const auto best = std::min_element(
        found.begin(), found.end(), [](const auto& a, const auto& b) {
          return a.fit.result.error < b.fit.result.error;
        });
    const PlacedEffect own = best->own();
    const double before = best->fit.result.error;
    std::vector<PlacedEffect> tries;
    for (const int node :
         nearest(*fitter.setting().setting.deck, own.where.node, neighbours)) {
      if (!seen.insert(node).second) continue;
      PlacedEffect next = own;
      next.where.node = node;
      if (!present(current, next)) tries.push_back(next);
    }
    if (tries.empty()) return;
    std::vector<PlacedEffect> all = current.effects;
    all.insert(all.end(), tries.begin(), tries.end());
    const auto model = fitter.model_for(all);
    double after = before;
    for (Hypothesis& h : fit_each(current, tries, fitter, model, progress)) {
      after = std::min(after, h.fit.result.error);
      found.push_back(std::move(h));
    }
    if (after >= before) return;
  }
}

// What is worth a full fit of one kind: its best screened places, or all where
// it is not screened.
std::vector<PlacedEffect> worth_fitting(const effects::Effect& effect,
                                        const Fit& current,
                                        const std::vector<Screened>& screened,
                                        const effects::Setting& setting,
                                        const HypothesisOptions& options) {
  std::vector<PlacedEffect> tries;
  // Sensors and channels are few and each differs from the others.
  const bool few = effect.places(setting).size() <= few_places;
  bool seen = false;
  for (const Screened& s : screened) {
    if (s.placed.effect != &effect) continue;
    seen = true;
    const auto count = static_cast<int>(tries.size());
    if (!few && count == options.places_per_kind) break;
    if (s.error > options.promising * screened.front().error) break;
    if (!present(current, s.placed)) tries.push_back(s.placed);
  }
  if (seen) return tries;
  for (const Where& where : effect.places(setting)) {
    const PlacedEffect p = placed(effect, where, setting);
    if (!present(current, p)) tries.push_back(p);
  }
  return tries;
}

}  // namespace

std::vector<Hypothesis> fit_hypotheses(const Fit& current,
                                       const Fitter& fitter,
                                       const HypothesisOptions& options,
                                       const Progress& progress) {
  const effects::Setting& setting = fitter.setting().setting;
  const std::vector<Screened> screened = screen(current, fitter, progress);
  std::map<const effects::Effect*, double> places;
  for (const Screened& s : screened) places[s.placed.effect] += 1.0;
  std::vector<Hypothesis> all;
  double done = 0.0;
  for (const auto& effect : effects::catalogue()) {
    progress("fitting " + effect->name(),
             done++ / static_cast<double>(effects::catalogue().size()));
    const std::vector<PlacedEffect> tries =
        worth_fitting(*effect, current, screened, setting, options);
    if (tries.empty()) continue;
    // A change of the stiffness needs a base of its own; others share one.
    const bool points = tries.front().where.node != 0;
    std::shared_ptr<const FrfModel> shared;
    if (!effect->changes_stiffness()) {
      std::vector<PlacedEffect> together = current.effects;
      together.insert(together.end(), tries.begin(), tries.end());
      shared = fitter.model_for(together);
    }
    std::vector<Hypothesis> found =
        fit_each(current, tries, fitter, shared, progress);
    if (points && options.neighbours > 0) {
      climb(found, current, fitter, options.neighbours, progress);
    }
    for (Hypothesis& h : found) {
      // A grid that the screening passed over was still a place to look at.
      h.places = std::max(
          {places[effect.get()],
           static_cast<double>(tries.size()),
           points ? static_cast<double>(setting.deck->grids.size()) : 1.0});
      all.push_back(std::move(h));
    }
  }
  return all;
}

}  // namespace tapfit::updating
