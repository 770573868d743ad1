#include "updating/frf_model/acted_points.hpp"

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
        const bool across = dof.component > 3
                                ? dof.component - 3 == setting.component
                                : dof.component != setting.component;
        if (across && !arms.contains(dof.node)) continue;
        points.insert(6 * static_cast<int>(setting.deck->grid_index(dof.node)) +
                      dof.component - 1);
      }
    }
  }
  return {points.begin(), points.end()};
}

std::vector<int> measured_points(const structure::Deck& deck,
                                 const acquisition::TestBundle& bundle) {
  std::set<int> points;
  const auto insert = [&](const acquisition::Placement& p) {
    points.insert(6 * static_cast<int>(deck.grid_index(p.dof.node)) +
                  p.dof.component - 1);
  };
  for (const acquisition::Run& run : bundle.runs) {
    insert(run.hammer);
    for (const acquisition::Placement& p : run.sensors) insert(p);
  }
  return {points.begin(), points.end()};
}

}  // namespace tapfit::updating
