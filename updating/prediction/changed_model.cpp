#include "updating/prediction/changed_model.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/frf_model/mesh_at_state.hpp"
#include "updating/prediction/stated_change.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

// A change of stiffness is known to the base by effect and place.
void refuse_twice(const std::vector<EffectInstance>& all) {
  for (auto one = all.begin(); one != all.end(); ++one) {
    if (!one->effect->changes_stiffness()) continue;
    const bool twice =
        std::any_of(all.begin(), one, [&one](const EffectInstance& other) {
          return other.effect == one->effect && other.where == one->where;
        });
    if (!twice) continue;
    throw InputError("it is in the model already",
                     effect_text(one->effect->name(), one->where),
                     "state the change at another place, or leave the effect "
                     "out of the model by --with");
  }
}

/// @param reference by which the damping ratios are the modes'
std::shared_ptr<const FrfModel> at_state(const FrfModel& model,
                                         const ModelState& state,
                                         const ModelState& reference) {
  auto own = std::make_shared<FrfModel>(model);
  own->set_reference(reference);
  if (model.coarser() == nullptr) return own;
  const std::size_t mesh =
      state.factor.size() - model.base().corrections.size();
  return with_mesh_at(*own, *model.coarser(), state, mesh);
}

}  // namespace

ModelState ChangedModel::changed(const Eigen::VectorXd& theta) const {
  ModelState result = unpack(state, theta);
  result.effects.insert(result.effects.end(), changes.begin(), changes.end());
  return result;
}

ChangedModel changed_model(const Fit& fit,
                           const Fitter& fitter,
                           const std::vector<EffectInstance>& changes) {
  ChangedModel result;
  result.state = fit.result.state;
  result.changes = changes;
  const ModelState after = result.changed();
  refuse_twice(after.effects);
  const auto model = fitter.model_for(after.effects);
  for (const EffectInstance& change : changes) check_size(change, *model);
  const ModelState reference = fitter.first_state(*model, result.state.effects);
  result.now = at_state(*model, result.state, reference);
  result.after = at_state(*model, after, reference);
  return result;
}

Eigen::MatrixXd parameter_spread(const Fit& fit) {
  const ModelState& state = fit.result.state;
  const Eigen::Index n = state.parameters();
  Eigen::MatrixXd C = fit.result.covariance;
  if (C.rows() != n) return Eigen::MatrixXd::Zero(n, n);
  auto k = static_cast<Eigen::Index>(state.factor.size()) + state.zeta.size();
  for (const EffectInstance& placed : state.effects) {
    const auto specs = parameters_of(placed, *fit.model);
    for (std::size_t j = 0; j < specs.size(); ++j, ++k) {
      const double most =
          0.5 * (specs[j].upper - specs[j].lower) / std::abs(placed.p[j]);
      const double sd = std::sqrt(std::max(C(k, k), 0.0));
      if (!(sd > most)) continue;
      C.row(k) *= most / sd;
      C.col(k) *= most / sd;
    }
  }
  return C;
}

}  // namespace tapfit::updating
