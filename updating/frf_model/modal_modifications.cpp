#include "updating/frf_model/modal_modifications.hpp"

#include <algorithm>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::RowVectorXd acted_row(const effects::InterfaceDof& dof,
                             const structure::Deck& deck,
                             const ReducedBase& base) {
  const auto of = [&](int node, int component) {
    return base.rows.row(6 * static_cast<Index>(deck.grid_index(node)) +
                         component - 1);
  };
  if (dof.between.empty()) return of(dof.node, dof.component);
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(base.size());
  for (const MotionShare& share : dof.between) {
    sum += share.weight * of(share.node, share.component);
  }
  return sum;
}

namespace {

// What a unit of the change's parameter adds: law = sum of p (k + s^2 m).
void add_unit(const EffectInstance& placed,
              const effects::TestContext& context,
              std::size_t run,
              const ReducedBase& base,
              ModalModification& change) {
  for (const effects::InterfaceDof& dof :
       placed.effect->interface_dofs(placed.where, context, run)) {
    const VectorXd b = acted_row(dof, *context.deck, base).transpose();
    const auto law_of_unit = [&](double s) {
      return dof.weight *
             placed.effect
                 ->law_derivative(s, placed.p, dof.group, change.parameter)
                 .real();
    };
    const auto add = [&b](double c, MatrixXd& sum) {
      if (c == 0.0) return;
      if (sum.size() == 0) sum.setZero(b.size(), b.size());
      sum.noalias() += c * b * b.transpose();
    };
    const double stiffness = law_of_unit(0.0);
    add(stiffness, change.dK);
    add(law_of_unit(1.0) - stiffness, change.dM);
  }
}

// Whether an effect on few degrees of freedom is alike in these runs.
bool stays(const EffectInstance& placed,
           const effects::TestContext& context,
           const std::vector<std::size_t>& runs) {
  const effects::Effect& effect = *placed.effect;
  if (runs.empty() || effect.entry() != effects::Entry::LowRank) return false;
  const auto acts = effect.interface_dofs(placed.where, context, runs.front());
  return std::all_of(runs.begin() + 1, runs.end(), [&](std::size_t run) {
    return effect.interface_dofs(placed.where, context, run) == acts;
  });
}

}  // namespace

std::vector<EffectInstance> outside_modal_basis(
    const ModelState& state,
    const effects::TestContext& context,
    const std::vector<std::size_t>& runs) {
  std::vector<EffectInstance> rest = state.effects;
  for (EffectInstance& placed : rest) {
    if (!stays(placed, context, runs)) continue;
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      if (placed.effect->is_lossless(p)) placed.p[p] = 0.0;
    }
  }
  return rest;
}

std::vector<ModalModification> modal_modifications(
    const ModelState& state,
    const effects::TestContext& context,
    const std::vector<std::size_t>& runs,
    const ReducedBase& base) {
  std::vector<ModalModification> changes;
  for (std::size_t e = 0; e < state.effects.size(); ++e) {
    const EffectInstance& placed = state.effects[e];
    if (!stays(placed, context, runs)) continue;
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      if (!placed.effect->is_lossless(p)) continue;
      changes.push_back({e, p, {}, {}});
      add_unit(placed, context, runs.front(), base, changes.back());
    }
  }
  return changes;
}

}  // namespace tapfit::updating
