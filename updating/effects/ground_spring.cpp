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

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    // Stiffness that the structure's own mass has at the band's two ends.
    double lower = 1e-4 * context.mass_kg * context.low() * context.low();
    double upper = 10.0 * context.mass_kg * context.high() * context.high();
    if (context.suspension) {
      const InterfaceDof at =
          motion_of(where, component_of(where, context), context);
      upper = std::min(upper,
                       stiffest_spring(*context.suspension, at, *context.deck));
      lower = std::min(lower, 1e-4 * upper);
    }
    return {spread("stiffness_n_per_m", lower, upper)};
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    return ground_spring_cards(
        *context.deck, 0, where.node, component_of(where, context), p[0]);
  }
};

}  // namespace

const Effect& ground_spring() {
  static const GroundSpring effect;
  return effect;
}

}  // namespace tapfit::effects
