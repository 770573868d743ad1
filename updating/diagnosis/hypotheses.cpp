#include "updating/diagnosis/hypotheses.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/diagnosis/screening.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/places/crack_line.hpp"
#include "updating/places/near_places.hpp"
#include "updating/places/stretched_patches.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <utility>

namespace tapfit::updating {
namespace {

// A climb goes on while it gains: across a structure if need be.
constexpr int most_steps = 40;
// Places around the best of a kind are looked at where it leaves at most this
// times the error of the best of all.
constexpr double rival = 4.0;
// Of the logarithm of a likelihood, what is worth a name of its own. Whether it
// is worth its parameters the evidence tells.
constexpr double clearly = 1.0;

// Whether any of what it acts on can move: a model of bars in a plane does not
// turn out of it.
bool acts(const PlacedEffect& placed, const FrfModel& model) {
  const std::vector<effects::ActedDof> dofs =
      placed.effect->acts_on(placed.where, model.setting(), 0);
  std::map<std::size_t, double> moves;
  for (const effects::ActedDof& dof : dofs) {
    moves[dof.group] += model.row(dof).norm();
  }
  return std::ranges::none_of(moves,
                              [](const auto& g) { return g.second == 0.0; });
}

// Fits the present effects and one more.
//
// @param shared its base; null: it gets its own
// @param beside a fit of the same at a place beside, from which it goes on
Fit fit_one(const Fit& current,
            const PlacedEffect& more,
            const Fitter& fitter,
            const std::shared_ptr<const FrfModel>& shared,
            const Progress& progress,
            const Fit* beside = nullptr) {
  std::vector<PlacedEffect> effects = current.effects;
  effects.push_back(more);
  const auto model = shared ? shared : fitter.model_for(effects);
  return beside != nullptr
             ? fitter.fit_beside(*beside, effects, model, progress)
             : fitter.fit(effects, model, progress);
}

// The same for each of several; those that end at what there is not are left
// out.
//
// @param shared one base for all of them; empty: each gets its own
// @param beside a fit of the same at a place beside, from which they go on
std::vector<Hypothesis> fit_each(const Fit& current,
                                 const std::vector<PlacedEffect>& extras,
                                 const Fitter& fitter,
                                 const std::shared_ptr<const FrfModel>& shared,
                                 const Progress& progress,
                                 const Fit* beside = nullptr) {
  std::vector<Hypothesis> result(extras.size());
  // Only this thread reports; the others only listen for the stop.
  const Progress quiet{{}, progress.stop};
  for_each_parallel(extras.size(), [&](std::size_t k) {
    result[k].fit = fit_one(current, extras[k], fitter, shared, quiet, beside);
  });
  std::erase_if(result, [](const Hypothesis& h) {
    return !h.own().effect->is_plausible(h.own().where, h.own().p);
  });
  return result;
}

bool less_error(const Hypothesis& a, const Hypothesis& b) {
  return a.fit.result.error < b.fit.result.error;
}

bool is_likelier(const Hypothesis& a, const Hypothesis& b) {
  return a.fit.log_likelihood > b.fit.log_likelihood;
}

/// The neighbours of a place.
using Near = std::function<std::vector<Where>(const Where&)>;

/// Whether one is better than another.
using Better = bool (*)(const Hypothesis&, const Hypothesis&);

// Around the best place of a kind, step to a better neighbour until there is
// none. Each step fits all neighbours, grids in one base.
void climb(std::vector<Hypothesis>& found,
           Better better,
           const Fit& current,
           const Fitter& fitter,
           const Near& near,
           const Progress& progress) {
  std::vector<Where> seen;
  for (const Hypothesis& h : found) seen.push_back(h.own().where);
  for (int round = 0; round < most_steps; ++round) {
    const Hypothesis best =
        *std::min_element(found.begin(), found.end(), better);
    const PlacedEffect& own = best.own();
    std::vector<PlacedEffect> tries;
    for (const Where& where : near(own.where)) {
      if (std::find(seen.begin(), seen.end(), where) != seen.end()) continue;
      seen.push_back(where);
      PlacedEffect next = own;
      next.where = where;
      if (!is_present(current, next)) tries.push_back(next);
    }
    if (tries.empty()) return;
    std::shared_ptr<const FrfModel> shared;
    if (!own.effect->changes_stiffness()) {
      std::vector<PlacedEffect> all = current.effects;
      all.insert(all.end(), tries.begin(), tries.end());
      shared = fitter.model_for(all);
    }
    bool gained = false;
    for (Hypothesis& h :
         fit_each(current, tries, fitter, shared, progress, &best.fit)) {
      gained = gained || better(h, best);
      found.push_back(std::move(h));
    }
    if (!gained) return;
  }
}

void climb_places(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  int neighbours,
                  const Progress& progress) {
  const effects::Setting& setting = fitter.setting().setting;
  const PlacedEffect& any = found.front().own();
  const bool is_loss = any.effect->changes_stiffness() == ChangeKind::Elements;
  const std::vector<Where>& all = fitter.places(*any.effect);
  const auto near = [&](const Where& at) {
    std::vector<Where> places = places_near(at, all, *setting.deck, neighbours);
    for (Where& where : places) {
      if (is_loss) where.variant = at.variant;
    }
    return places;
  };
  climb(found, is_likelier, current, fitter, near, progress);
}

// Patches are looked for as cubes; what is lost may be a long one. What a patch
// is short of looks like an error of form to the likelihood, which sees no way
// on; the error falls with every layer that belongs to it.
void climb_shapes(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  const Progress& progress) {
  const structure::Deck& deck = *fitter.setting().setting.deck;
  const auto near = [&deck](const Where& at) {
    std::vector<Where> places;
    for (std::vector<int>& ids : stretched_patches(at.elements, deck)) {
      places.push_back(at);
      places.back().elements = std::move(ids);
    }
    return places;
  };
  climb(found, less_error, current, fitter, near, progress);
}

// A crack begins and ends at some grid of its line.
void climb_cracks(std::vector<Hypothesis>& found,
                  const Fit& current,
                  const Fitter& fitter,
                  const Progress& progress) {
  const structure::Deck& deck = *fitter.setting().setting.deck;
  const auto near = [&deck](const Where& at) {
    std::vector<Where> places;
    for (std::vector<int>& nodes : cracks_near(deck, at.nodes)) {
      if (crack_line(deck, nodes).grids.empty()) continue;
      places.push_back(at);
      places.back().nodes = std::move(nodes);
    }
    return places;
  };
  climb(found, is_likelier, current, fitter, near, progress);
}

// One kind and what was fitted of it.
struct Kind {
  const effects::Effect* effect = nullptr;
  std::vector<Hypothesis> found;
  double tries = 0.0;  // from the screening

  [[nodiscard]] bool at_grids() const {
    return is_at_grid(found.front().own().where);
  }
  // Supports, sensors and channels are few: all were looked at.
  [[nodiscard]] bool has_neighbours() const {
    const auto changes = effect->changes_stiffness();
    return at_grids() || changes == ChangeKind::Elements ||
           changes == ChangeKind::Joint;
  }
  [[nodiscard]] bool is_loss() const {
    return effect->changes_stiffness() == ChangeKind::Elements;
  }
  [[nodiscard]] bool is_joint() const {
    return effect->changes_stiffness() == ChangeKind::Joint;
  }
  [[nodiscard]] double log_likelihood() const {
    return std::min_element(found.begin(), found.end(), is_likelier)
        ->fit.log_likelihood;
  }
  [[nodiscard]] double error() const {
    return std::min_element(found.begin(), found.end(), less_error)
        ->fit.result.error;
  }
};

// Fits all that is planned, on all cores whatever kind it is of.
std::vector<Kind> fit_planned(std::vector<Planned> plans,
                              const Fit& current,
                              const Fitter& fitter,
                              const Progress& progress) {
  for_each_parallel(plans.size(), [&](std::size_t k) {
    if (plans[k].tries.empty() || plans[k].effect->changes_stiffness()) return;
    std::vector<PlacedEffect> together = current.effects;
    together.insert(
        together.end(), plans[k].tries.begin(), plans[k].tries.end());
    plans[k].shared = fitter.model_for(together);
  });
  std::vector<Kind> kinds;
  std::vector<std::pair<std::size_t, std::size_t>> all;  // kind, hypothesis
  for (const Planned& plan : plans) {
    const std::size_t count = plan.tries.size();
    for (std::size_t t = 0; t < count; ++t) all.emplace_back(kinds.size(), t);
    kinds.push_back({plan.effect,
                     std::vector<Hypothesis>(count),
                     static_cast<double>(count)});
  }
  const auto caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  for_each_parallel(all.size(), [&](std::size_t n) {
    const auto [k, t] = all[n];
    kinds[k].found[t].fit = fit_one(current,
                                    plans[k].tries[t],
                                    fitter,
                                    plans[k].shared,
                                    {{}, progress.stop});
    ++done;
    // The other threads only listen for the stop.
    if (std::this_thread::get_id() != caller) return;
    progress("fitting effects",
             static_cast<double>(done) / static_cast<double>(all.size()));
  });
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (plans[k].known != nullptr) kinds[k].found.push_back({*plans[k].known});
  }
  return kinds;
}

double least_error(const std::vector<Kind>& kinds) {
  double least = 1e300;
  for (const Kind& kind : kinds) least = std::min(least, kind.error());
  return least;
}

// From the best place of a kind to what is around it.
void climb_from_best(Kind& kind,
                     const Fit& current,
                     const Fitter& fitter,
                     const HypothesisOptions& options,
                     const Progress& progress) {
  if (!kind.has_neighbours()) return;
  climb_places(kind.found, current, fitter, options.neighbours, progress);
  if (kind.is_loss() && kind.error() > options.explained) {
    climb_shapes(kind.found, current, fitter, progress);
  }
}

// The screening is of first order, and a loss of stiffness or a joint is often
// far from small: the right place may not be among those fitted. Grids first:
// they share a base, and what they leave is the measure for the others.
void climb_rivals(std::vector<Kind>& kinds,
                  const Fit& current,
                  const Fitter& fitter,
                  const HypothesisOptions& options,
                  const Progress& progress) {
  for (const bool grids : {true, false}) {
    const double least = least_error(kinds);
    for (Kind& kind : kinds) {
      if (kind.at_grids() != grids || kind.error() > rival * least) continue;
      climb_from_best(kind, current, fitter, options, progress);
    }
  }
}

// Where a kind may have another form: at the best of its grids, at a few
// patches apart, or wherever supports and sensors, which are few, were looked
// at.
std::vector<Where> places_for_forms(const Kind& kind,
                                    const structure::Deck& deck) {
  constexpr std::size_t most_apart = 3;
  std::vector<const Hypothesis*> order;
  for (const Hypothesis& h : kind.found) order.push_back(&h);
  std::ranges::stable_sort(
      order, [](const auto* a, const auto* b) { return is_likelier(*a, *b); });
  std::vector<Where> places;
  for (const Hypothesis* h : order) {
    const Where& where = h->own().where;
    const bool near = std::ranges::any_of(places, [&](const Where& other) {
      return kind.is_loss() && within_reach(other, where, {}, deck, 0);
    });
    if (!near) places.push_back(where);
    if (kind.at_grids()) break;
    const bool wide = kind.is_loss() || kind.is_joint();
    if (wide && places.size() == most_apart) break;
  }
  return places;
}

// What does well where it was found may do better in another form: a mass with
// an inertia, a clamp that varies along its line, elements that were thinned.
// It may then do better beside.
void try_forms(std::vector<Kind>& kinds,
               const Fit& current,
               const Fitter& fitter,
               const HypothesisOptions& options,
               const Progress& progress) {
  const double least = least_error(kinds);
  const effects::Setting& setting = fitter.setting().setting;
  for (Kind& kind : kinds) {
    if (kind.error() > rival * least) continue;
    std::vector<PlacedEffect> tries;
    for (const Where& where : forms_of(
             *kind.effect, places_for_forms(kind, *setting.deck), setting)) {
      PlacedEffect next = placed(*kind.effect, where, setting);
      if (acts(next, *current.model) && !is_present(current, next)) {
        tries.push_back(std::move(next));
      }
    }
    const double plain = kind.log_likelihood();
    std::vector<Hypothesis> formed =
        fit_each(current, tries, fitter, nullptr, progress);
    if (kind.is_joint() && !formed.empty()) {
      climb_cracks(formed, current, fitter, progress);
    }
    for (Hypothesis& h : formed) {
      // Else it is the plain one under another name.
      const bool better = h.fit.log_likelihood > plain + clearly;
      if (better) kind.found.push_back(std::move(h));
    }
    if (kind.log_likelihood() <= plain || kind.is_joint()) continue;
    climb_from_best(kind, current, fitter, options, progress);
  }
}

}  // namespace

std::vector<Hypothesis> fit_hypotheses(const Fit& current,
                                       const Fitter& fitter,
                                       const HypothesisOptions& options,
                                       const Progress& progress) {
  const effects::Setting& setting = fitter.setting().setting;
  const std::vector<Screened> screened =
      screen(current, fitter, part_of(progress, 0.0, 0.1));
  // A mistake in some runs is looked for in many more ways than one in all.
  std::map<std::pair<const effects::Effect*, bool>, double> places;
  for (const Screened& s : screened) {
    places[{s.placed.effect, s.placed.where.runs.empty()}] += s.places;
  }
  std::vector<Kind> kinds =
      fit_planned(planned_fits(current, screened, fitter, options),
                  current,
                  fitter,
                  part_of(progress, 0.1, 0.7));
  if (options.neighbours > 0) {
    const Progress rest = part_of(progress, 0.7, 1.0);
    climb_rivals(kinds, current, fitter, options, rest);
    if (least_error(kinds) > options.explained) {
      try_forms(kinds, current, fitter, options, rest);
    }
  }
  std::vector<Hypothesis> all;
  for (Kind& kind : kinds) {
    const structure::Deck& deck = *setting.deck;
    // A grid that the screening passed over was still a place to look at.
    const double grids =
        kind.at_grids()
            ? static_cast<double>(deck.grids.size() - deck.measuring.size())
            : 1.0;
    for (Hypothesis& h : kind.found) {
      h.places = std::max({places[{kind.effect, h.own().where.runs.empty()}],
                           kind.tries,
                           grids});
    }
    std::move(kind.found.begin(), kind.found.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace tapfit::updating
