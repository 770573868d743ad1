// A viscous damper from one grid to ground: Delta Z = s c along one axis.
#include "updating/effects/effects.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/structure/edit/deck_cards.hpp"

namespace tapfit::effects {
namespace {

class Dashpot final : public DirectedEffect {
 public:
  Dashpot() : DirectedEffect("dashpot", "damper to ground", Law::Damper) {}

  std::vector<ParameterSpec> parameters(
      const Location&, const TestContext& context) const override {
    // Around the damping that makes the whole mass critically damped.
    const double m = context.mass_kg;
    return {spread("damping_ns_per_m",
                   1e-4 * m * context.low(),
                   2.0 * m * context.high())};
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    return ground_damper_cards(
        *context.deck, 0, where.node, component_of(where, context), p[0]);
  }
};

}  // namespace

const Effect& dashpot() {
  static const Dashpot effect;
  return effect;
}

}  // namespace tapfit::effects
