#include "updating/diagnosis/made_fit.hpp"

#include "updating/catalogue/catalogue.hpp"

namespace tapfit::updating {
MadeFit as_made(const Fit& fit) {
  const ModelState& state = fit.result.state;
  MadeFit made;
  for (const EffectInstance& e : fit.effects) {
    made.effects.push_back({e.effect->name(), e.where});
    made.sizes.push_back(e.p);
  }
  made.factor = state.factor;
  made.zeta.assign(state.zeta.begin(), state.zeta.end());
  made.zeta_other = state.zeta_other;
  return made;
}

Fit where_it_ended(const MadeFit& made, const effects::TestContext& context) {
  Fit fit;
  for (std::size_t k = 0; k < made.effects.size(); ++k) {
    const EffectRef& ref = made.effects[k];
    fit.effects.push_back(
        placed(effects::find(ref.effect), ref.where, context));
    fit.effects.back().p = made.sizes[k];
  }
  ModelState& state = fit.result.state;
  state.factor = made.factor;
  state.zeta = Eigen::VectorXd::Map(
      made.zeta.data(), static_cast<Eigen::Index>(made.zeta.size()));
  state.zeta_other = made.zeta_other;
  state.effects = fit.effects;
  return fit;
}

}  // namespace tapfit::updating
