#include "updating/search/hypotheses.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/places/crack_line.hpp"
#include "updating/places/near_places.hpp"
#include "updating/places/stretched_patches.hpp"
#include "updating/residual/independent_data.hpp"
#include "updating/search/climb.hpp"
#include "updating/search/fit_each.hpp"
#include "updating/search/fit_planned.hpp"
#include "updating/search/screening.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

// Of the logarithm of a likelihood, what is worth a name of its own. Whether it
// is worth its parameters the evidence tells.
constexpr double clearly = 1.0;
// Whether there is a way up from here: none from what says no more than nothing
// does. That is what a parameter at the best of all places gains by chance,
// 1/2 ln(data) + ln(places).
bool tells(const Hypothesis& h, const Fit& current, const Fitter& fitter) {
  const double places =
      static_cast<double>(fitter.places(*h.own().effect).size());
  const double by_chance = 0.5 * std::log(effective_data(fitter.target())) +
                           std::log(std::max(1.0, places));
  return h.fit.log_likelihood > current.log_likelihood + by_chance;
}

// Whether any of what it acts on can move: a model of bars in a plane does not
// turn out of it.
bool acts(const EffectInstance& placed, const FrfModel& model) {
  const std::vector<effects::InterfaceDof> dofs =
      placed.effect->interface_dofs(placed.where, model.context(), 0);
  std::map<std::size_t, double> moves;
  for (const effects::InterfaceDof& dof : dofs) {
    moves[dof.group] += model.row(dof).norm();
  }
  return std::ranges::none_of(moves,
                              [](const auto& g) { return g.second == 0.0; });
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
  // Mass, frequency and damping.
  [[nodiscard]] bool resonates() const {
    return at_grids() && found.front().own().p.size() > 2;
  }
  [[nodiscard]] bool is_loss() const {
    return effect->changes_stiffness() == ChangeKind::Elements;
  }
  [[nodiscard]] bool is_joint() const {
    return effect->changes_stiffness() == ChangeKind::Joint;
  }
  [[nodiscard]] const Hypothesis& likeliest() const {
    return *std::min_element(found.begin(), found.end(), is_likelier);
  }
  [[nodiscard]] double log_likelihood() const {
    return likeliest().fit.log_likelihood;
  }
  [[nodiscard]] bool is_hopeless(const Reach& reach) const {
    return std::ranges::all_of(
        found, [&reach](const Hypothesis& h) { return reach.is_hopeless(h); });
  }
  [[nodiscard]] double error() const {
    return std::min_element(found.begin(), found.end(), less_error)
        ->fit.result.error;
  }
};

std::vector<Kind> fitted_kinds(std::vector<Planned> plans,
                               const Fit& current,
                               const Fitter& fitter,
                               const HypothesisOptions& options,
                               Reach& reach,
                               const Progress& progress) {
  std::vector<Kind> kinds;
  for (const Planned& plan : plans) {
    kinds.push_back({plan.effect, {}, static_cast<double>(plan.tries.size())});
  }
  auto found =
      fit_planned(std::move(plans), current, fitter, options, reach, progress);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    kinds[k].found = std::move(found[k]);
  }
  std::erase_if(kinds, [](const Kind& kind) { return kind.found.empty(); });
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
                     Reach& reach,
                     const Progress& progress) {
  if (!kind.has_neighbours()) return;
  if (kind.resonates()) {
    look_elsewhere(
        kind.found, current, fitter, options.neighbours, reach, progress);
  }
  climb_places(
      kind.found, current, fitter, options.neighbours, reach, progress);
}

// The screening is of first order, and a loss of stiffness or a joint is often
// far from small: the right place may not be among those fitted. Grids first:
// they share a base, and what they leave is the measure for the others.
void climb_rivals(std::vector<Kind>& kinds,
                  const Fit& current,
                  const Fitter& fitter,
                  const HypothesisOptions& options,
                  Reach& reach,
                  const Progress& progress) {
  for (const bool grids : {true, false}) {
    for (Kind& kind : kinds) {
      if (kind.at_grids() != grids || kind.is_hopeless(reach)) continue;
      if (!tells(kind.likeliest(), current, fitter)) continue;
      climb_from_best(kind, current, fitter, options, reach, progress);
    }
  }
}

// Where a kind may have another form: at the best of its grids or seams, at a
// few patches apart, or wherever supports and sensors, which are few, were
// looked at.
std::vector<Location> places_for_forms(const Kind& kind,
                                       const structure::Deck& deck) {
  constexpr std::size_t most_apart = 3;
  std::vector<const Hypothesis*> order;
  for (const Hypothesis& h : kind.found) order.push_back(&h);
  std::ranges::stable_sort(
      order, [](const auto* a, const auto* b) { return is_likelier(*a, *b); });
  std::vector<Location> places;
  for (const Hypothesis* h : order) {
    const Location& where = h->own().where;
    const bool near = std::ranges::any_of(places, [&](const Location& other) {
      return kind.is_loss() && within_reach(other, where, {}, deck, 0);
    });
    if (!near) places.push_back(where);
    if (kind.at_grids() || kind.is_joint()) break;
    if (kind.is_loss() && places.size() == most_apart) break;
  }
  return places;
}

// A patch that has lost next to all of its stiffness may be a crack, which the
// seams that do well as joints are not near.
std::vector<Location> cracks_in_patches(const std::vector<Kind>& kinds,
                                        const Reach& reach,
                                        const Fit& current,
                                        const Fitter& fitter) {
  constexpr double next_to_all = 0.25;  // left
  std::vector<Location> places;
  for (const Kind& kind : kinds) {
    if (!kind.is_loss() || kind.is_hopeless(reach)) continue;
    const Hypothesis* best = nullptr;
    for (const Hypothesis& h : kind.found) {
      if (h.own().p.front() > next_to_all || !tells(h, current, fitter))
        continue;
      if (best == nullptr || is_likelier(h, *best)) best = &h;
    }
    if (best == nullptr || reach.is_hopeless(*best)) continue;
    for (std::vector<int>& nodes : cracks_within(*fitter.problem().context.deck,
                                                 best->own().where.elements)) {
      places.emplace_back().nodes = std::move(nodes);
    }
  }
  return places;
}

// Else it is the plain one under another name.
void take_better(std::vector<Hypothesis> formed, Kind& kind) {
  const double plain = kind.log_likelihood();
  for (Hypothesis& h : formed) {
    const bool better = h.fit.log_likelihood > plain + clearly;
    if (better) kind.found.push_back(std::move(h));
  }
}

// The best patch with edges within elements, and, as it may be a layer too
// large, what is inside of it.
void try_edges(Kind& kind,
               const Fit& current,
               const Fitter& fitter,
               Reach& reach,
               const Progress& progress) {
  const effects::TestContext& context = fitter.problem().context;
  Location where = kind.likeliest().own().where;
  where.variant = takes_mass(where) ? pocket_edges : edges;
  std::vector<EffectInstance> tries = {placed(*kind.effect, where, context)};
  if (is_present(current, tries.front())) return;
  std::vector<int> inner = inner_patch(where.elements, *context.deck);
  if (inner != where.elements) {
    where.elements = std::move(inner);
    tries.push_back(placed(*kind.effect, where, context));
  }
  take_better(fit_each(current, tries, fitter, reach, progress), kind);
}

// What does well where it was found may do better in another form: a mass with
// an inertia, a clamp that varies along its line, elements that were thinned.
// It may then do better beside.
void try_forms(std::vector<Kind>& kinds,
               const Fit& current,
               const Fitter& fitter,
               const HypothesisOptions& options,
               Reach& reach,
               const Progress& progress) {
  const effects::TestContext& context = fitter.problem().context;
  for (Kind& kind : kinds) {
    std::vector<Location> places;
    // A form refines a place among many, but of a support it may be far more
    // than the plain one.
    const bool in_reach = !kind.has_neighbours() || !kind.is_hopeless(reach);
    if (in_reach &&
        (!kind.is_joint() || tells(kind.likeliest(), current, fitter))) {
      places = places_for_forms(kind, *context.deck);
    }
    if (kind.is_joint()) {
      std::ranges::copy(cracks_in_patches(kinds, reach, current, fitter),
                        std::back_inserter(places));
    }
    if (places.empty()) continue;
    std::vector<EffectInstance> tries;
    for (const Location& where : forms_of(*kind.effect, places, context)) {
      if (has_edges(where)) continue;  // of the best that there is, below
      EffectInstance next = placed(*kind.effect, where, context);
      if (acts(next, *current.model) && !is_present(current, next)) {
        tries.push_back(std::move(next));
      }
    }
    const double plain = kind.log_likelihood();
    std::vector<Hypothesis> formed =
        fit_each(current, tries, fitter, reach, progress);
    if (kind.is_joint() && !formed.empty()) {
      climb_cracks(formed, current, fitter, reach, progress);
    }
    take_better(std::move(formed), kind);
    if (kind.log_likelihood() > plain && !kind.is_joint()) {
      climb_from_best(kind, current, fitter, options, reach, progress);
    }
    if (!kind.is_loss() || kind.error() <= options.explained) continue;
    if (!kind.is_hopeless(reach) && tells(kind.likeliest(), current, fitter)) {
      climb_shapes(kind.found, current, fitter, reach, progress);
    }
    // They refine what nothing else explains better.
    if (kind.error() <= least_error(kinds)) {
      try_edges(kind, current, fitter, reach, progress);
    }
  }
}

}  // namespace

std::vector<Hypothesis> fit_hypotheses(const Fit& current,
                                       const Fitter& fitter,
                                       const HypothesisOptions& options,
                                       const Progress& progress) {
  const effects::TestContext& context = fitter.problem().context;
  const std::vector<Screened> screened =
      screen(current, fitter, part_of(progress, 0.0, 0.1));
  // A mistake in some runs is looked for in many more ways than one in all.
  std::map<std::pair<const effects::Effect*, bool>, double> places;
  for (const Screened& s : screened) {
    places[{s.placed.effect, s.placed.where.runs.empty()}] += s.places;
  }
  Reach reach(current, fitter);
  for (const Fit* known : {options.known, options.rival}) {
    if (known != nullptr) reach.take_known(*known, fitter);
  }
  std::vector<Kind> kinds =
      fitted_kinds(planned_fits(current, screened, fitter, options, reach),
                   current,
                   fitter,
                   options,
                   reach,
                   part_of(progress, 0.1, 0.7));
  if (options.neighbours > 0) {
    const Progress rest = part_of(progress, 0.7, 1.0);
    climb_rivals(kinds, current, fitter, options, reach, rest);
    if (current.result.error > options.explained) {
      try_forms(kinds, current, fitter, options, reach, rest);
    }
  }
  std::vector<Hypothesis> all;
  for (Kind& kind : kinds) {
    const structure::Deck& deck = *context.deck;
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

void add_forms_of_few(std::vector<Hypothesis>& found,
                      const Fit& current,
                      const Fitter& fitter,
                      const Progress& progress) {
  Reach reach(current, fitter);
  for (const Hypothesis& h : found) reach.take(h);
  std::vector<Kind> few;
  for (const Hypothesis& h : found) {
    Kind kind{h.own().effect, {h}, h.places};
    if (kind.has_neighbours() || reach.is_hopeless(h)) continue;
    const auto known = std::ranges::find(few, kind.effect, &Kind::effect);
    if (known == few.end()) {
      few.push_back(std::move(kind));
    } else {
      known->found.push_back(h);
    }
  }
  std::map<const effects::Effect*, std::size_t> plain;
  for (const Kind& kind : few) plain[kind.effect] = kind.found.size();
  try_forms(few, current, fitter, {}, reach, progress);
  for (Kind& kind : few) {
    for (std::size_t k = plain[kind.effect]; k < kind.found.size(); ++k) {
      found.push_back(std::move(kind.found[k]));
      found.back().places = kind.tries;
    }
  }
}

}  // namespace tapfit::updating
