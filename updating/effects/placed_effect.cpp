#include "updating/effects/placed_effect.hpp"

namespace tapfit::updating {

effects::ModeDamping PlacedEffect::mode_damping(double omega) const {
  effects::ModeDamping sum;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const effects::ModeDamping unit = effect->mode_damping(omega, k);
    sum.c += p[k] * unit.c;
    sum.slope += p[k] * unit.slope;
  }
  return sum;
}

PlacedEffect placed(const effects::Effect& effect,
                    const Where& where,
                    const effects::Setting& setting) {
  PlacedEffect result{&effect, where, {}};
  for (const effects::ParameterSpec& spec : effect.parameters(where, setting)) {
    result.p.push_back(spec.start);
  }
  return result;
}

}  // namespace tapfit::updating
