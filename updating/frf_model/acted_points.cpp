#include "updating/frf_model/acted_points.hpp"

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

}  // namespace

std::vector<int> acted_points(const effects::Setting& setting,
                              const std::vector<PlacedEffect>& effects) {
  const std::set<int> arms = rigidly_joined(*setting.deck);
  std::set<int> points;
  for (const PlacedEffect& e : effects) {
    for (std::size_t run = 0; run < setting.bundle->runs.size(); ++run) {
      for (const effects::ActedDof& dof :
           e.effect->acts_on(e.where, setting, run)) {
        // Residual vectors across the measured direction, or turning about
        // it, would only swell the base: the modes there are stiff and hardly
        // excited.
        const bool across =
            dof.component > 3
                ? dof.component - 3 == setting.component
                : dof.component != setting.component && !is_along_axis(e.where);
        if (across && !arms.contains(dof.node)) continue;
        const auto insert = [&](int node) {
          points.insert(6 * static_cast<int>(setting.deck->grid_index(node)) +
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
  const auto dof = [&](const acquisition::Placement& p) {
    return 6 * static_cast<int>(deck.grid_index(p.dof.node)) + p.dof.component -
           1;
  };
  for (const acquisition::Run& run : bundle.runs) {
    hit.insert(dof(run.hammer));
    for (const acquisition::Placement& p : run.sensors) sensed.insert(dof(p));
  }
  const std::set<int>& fewer = hit.size() < sensed.size() ? hit : sensed;
  MeasuredPoints points;
  points.driven.assign(fewer.begin(), fewer.end());
  std::ranges::set_union(hit, sensed, std::back_inserter(points.all));
  return points;
}

}  // namespace tapfit::updating
