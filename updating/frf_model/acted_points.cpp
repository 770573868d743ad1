#include "updating/frf_model/acted_points.hpp"

#include "updating/frf_model/test_as_done.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace tapfit::updating {
namespace {

// On an arm a grid moves across the measured direction as softly as along it.
std::set<int> rigidly_joined(const structure::Deck& deck) {
  std::set<int> grids;
  for (const structure::RigidElement& e : deck.rigids) {
    grids.insert(e.independent);
    for (const structure::Dependent& d : e.dependents) grids.insert(d.grid);
  }
  for (const structure::Relation& e : deck.relations) {
    grids.insert(e.grid);
    for (const structure::RelationTerm& term : e.terms) grids.insert(term.grid);
  }
  return grids;
}

int point_of(const structure::Deck& deck, const acquisition::Placement& p) {
  return 6 * static_cast<int>(deck.grid_index(p.dof.node)) + p.dof.component -
         1;
}

// Where something was hit or measured that the sheet has elsewhere.
std::set<int> corrected_points(const effects::TestContext& written,
                               const TestAsDone& done) {
  std::set<int> points;
  if (!done.sheet) return points;
  const auto take = [&](const acquisition::Placement& was,
                        const acquisition::Placement& is) {
    if (was.dof != is.dof) points.insert(point_of(*written.deck, is));
  };
  for (std::size_t r = 0; r < done.sheet->runs.size(); ++r) {
    const acquisition::Run& was = written.bundle->runs[r];
    const acquisition::Run& is = done.sheet->runs[r];
    take(was.hammer, is.hammer);
    for (std::size_t k = 0; k < is.sensors.size(); ++k) {
      take(was.sensors[k], is.sensors[k]);
    }
  }
  return points;
}

}  // namespace

std::vector<int> acted_points(const effects::TestContext& context,
                              const std::vector<EffectInstance>& effects) {
  const std::set<int> arms = rigidly_joined(*context.deck);
  const TestAsDone done = test_as_done(context, effects);
  std::set<int> points = corrected_points(context, done);
  // They may be tried one by one and disagree about a point.
  for (const EffectInstance& e : effects) {
    points.merge(corrected_points(context, test_as_done(context, {e})));
  }
  // A test of modes has no runs, but is done with all that acts.
  const std::size_t runs =
      std::max<std::size_t>(context.bundle->runs.size(), 1);
  for (const EffectInstance& e : effects) {
    for (std::size_t run = 0; run < runs; ++run) {
      for (const effects::InterfaceDof& dof :
           e.effect->interface_dofs(e.where, done.context, run)) {
        // Residual vectors across the measured direction, or turning about
        // it, would only swell the base: the modes there are stiff and hardly
        // excited.
        const bool across =
            dof.component > 3
                ? dof.component - 3 == context.component
                : dof.component != context.component && !is_along_axis(e.where);
        if (across && !arms.contains(dof.node)) continue;
        const auto insert = [&](int node) {
          points.insert(6 * static_cast<int>(context.deck->grid_index(node)) +
                        dof.component - 1);
        };
        if (dof.between.empty()) insert(dof.node);
        for (const MotionShare& share : dof.between) insert(share.node);
      }
    }
  }
  return {points.begin(), points.end()};
}

MeasuredPoints measured_points(const structure::Deck& deck,
                               const acquisition::TestBundle& bundle) {
  std::set<int> hit;
  std::set<int> sensed;
  for (const acquisition::Run& run : bundle.runs) {
    hit.insert(point_of(deck, run.hammer));
    for (const acquisition::Placement& p : run.sensors) {
      sensed.insert(point_of(deck, p));
    }
  }
  const std::set<int>& fewer = hit.size() < sensed.size() ? hit : sensed;
  MeasuredPoints points;
  points.driven.assign(fewer.begin(), fewer.end());
  std::ranges::set_union(hit, sensed, std::back_inserter(points.all));
  return points;
}

}  // namespace tapfit::updating
