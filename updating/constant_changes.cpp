#include "updating/constant_changes.hpp"

#include <algorithm>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool goes_into_modes(const PlacedEffect& placed,
                     const effects::Setting& setting,
                     const std::vector<std::size_t>& runs) {
  const effects::Effect& effect = *placed.effect;
  if (runs.empty() || effect.entry() != effects::Entry::LowRank ||
      !effect.is_lossless()) {
    return false;
  }
  const auto acts = effect.acts_on(placed.where, setting, runs.front());
  return std::all_of(runs.begin() + 1, runs.end(), [&](std::size_t run) {
    return effect.acts_on(placed.where, setting, run) == acts;
  });
}

std::vector<ConstantChange> constant_changes(
    const ModelState& state,
    const effects::Setting& setting,
    const std::vector<std::size_t>& runs,
    const ReducedBase& base) {
  std::vector<ConstantChange> changes;
  for (std::size_t e = 0; e < state.effects.size(); ++e) {
    const PlacedEffect& placed = state.effects[e];
    if (!goes_into_modes(placed, setting, runs)) continue;
    const auto acts =
        placed.effect->acts_on(placed.where, setting, runs.front());
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      ConstantChange change{e, p, {}, {}};
      for (const effects::ActedDof& dof : acts) {
        const auto grid =
            static_cast<Index>(setting.deck->grid_index(dof.node));
        const VectorXd b =
            base.rows.row(6 * grid + dof.component - 1).transpose();
        const auto by_p = [&](double s) {
          return dof.weight *
                 placed.effect->law_derivative(s, placed.p, dof.group, p)
                     .real();
        };
        // law = sum of p (k + s^2 m)
        const double k = by_p(0.0);
        const double m = by_p(1.0) - k;
        const auto add = [&](double c, MatrixXd& sum) {
          if (c == 0.0) return;
          if (sum.size() == 0) sum.setZero(b.size(), b.size());
          sum.noalias() += c * b * b.transpose();
        };
        add(k, change.dK);
        add(m, change.dM);
      }
      changes.push_back(std::move(change));
    }
  }
  return changes;
}

}  // namespace tapfit::updating
