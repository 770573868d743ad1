#include "updating/frf_model/model_state.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::VectorXd;

Index ModelState::parameters() const {
  Index n = static_cast<Index>(factor.size()) + zeta.size();
  for (const EffectInstance& e : effects) n += static_cast<Index>(e.p.size());
  return n;
}

const EffectInstance* ModelState::damping_law() const {
  const auto it =
      std::find_if(effects.begin(), effects.end(), [](const EffectInstance& e) {
        return e.effect->entry() == effects::Entry::Damping;
      });
  return it == effects.end() ? nullptr : &*it;
}

double ModelState::zeta_at(double omega) const {
  const EffectInstance* law = damping_law();
  return law == nullptr ? zeta_other
                        : law->mode_damping(omega).c / (2.0 * omega);
}

VectorXd pack(const ModelState& state) {
  VectorXd theta(state.parameters());
  Index k = 0;
  for (const double f : state.factor) theta(k++) = std::log(f);
  for (const double z : state.zeta) theta(k++) = std::log(z);
  for (const EffectInstance& e : state.effects) {
    for (const double p : e.p) theta(k++) = std::log(p);
  }
  return theta;
}

ModelState unpack(const ModelState& like, const VectorXd& theta) {
  ModelState state = like;
  Index k = 0;
  for (double& f : state.factor) f = std::exp(theta(k++));
  for (double& z : state.zeta) z = std::exp(theta(k++));
  for (EffectInstance& e : state.effects) {
    for (double& p : e.p) p = std::exp(theta(k++));
  }
  return state;
}

}  // namespace tapfit::updating
