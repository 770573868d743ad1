#include "updating/effects/effect_instance.hpp"

namespace tapfit::updating {

effects::ModeDamping EffectInstance::mode_damping(double omega) const {
  effects::ModeDamping sum;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const effects::ModeDamping unit = effect->mode_damping(omega, k);
    sum.c += p[k] * unit.c;
    sum.slope += p[k] * unit.slope;
  }
  return sum;
}

EffectInstance placed(const effects::Effect& effect,
                      const Location& where,
                      const effects::TestContext& context) {
  EffectInstance result{&effect, where, {}};
  for (const effects::ParameterSpec& spec : effect.parameters(where, context)) {
    result.p.push_back(spec.start);
  }
  return result;
}

}  // namespace tapfit::updating
