// A spring from one grid to ground: Delta Z = k along one axis.
#include "updating/effects/effects.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/effects/suspension.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <algorithm>

namespace tapfit::effects {
namespace {

class GroundSpring final : public DirectedEffect {
 public:
  GroundSpring()
      : DirectedEffect("ground-spring", "spring to ground", Law::Spring) {}

  std::vector<ParameterSpec> parameters(const Where& where,
                                        const Setting& setting) const override {
    // Stiffness that the structure's own mass has at the band's two ends.
    double lower = 1e-4 * setting.mass_kg * setting.low() * setting.low();
    double upper = 10.0 * setting.mass_kg * setting.high() * setting.high();
    if (setting.suspension) {
      const ActedDof at =
          motion_of(where, component_of(where, setting), setting);
      upper = std::min(upper,
                       stiffest_spring(*setting.suspension, at, *setting.deck));
      lower = std::min(lower, 1e-4 * upper);
    }
    return {spread("stiffness_n_per_m", lower, upper)};
  }

  std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override {
    return ground_spring_cards(
        *setting.deck, 0, where.node, component_of(where, setting), p[0]);
  }
};

}  // namespace

const Effect& ground_spring() {
  static const GroundSpring effect;
  return effect;
}

}  // namespace tapfit::effects
