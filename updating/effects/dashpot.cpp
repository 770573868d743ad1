// A viscous damper from one grid to ground: Delta Z = s c along one axis.
#include "updating/effects/effects.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/structure/edit/deck_cards.hpp"

namespace tapfit::effects {
namespace {

class Dashpot final : public DirectedEffect {
 public:
  Dashpot() : DirectedEffect("dashpot", "damper to ground", Law::Damper) {}

  std::vector<ParameterSpec> parameters(const Where&,
                                        const Setting& setting) const override {
    // Around the damping that makes the whole mass critically damped.
    const double m = setting.mass_kg;
    return {spread("damping_ns_per_m",
                   1e-4 * m * setting.low(),
                   2.0 * m * setting.high())};
  }

  std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override {
    return ground_damper_cards(
        *setting.deck, 0, where.node, component_of(where, setting), p[0]);
  }
};

}  // namespace

const Effect& dashpot() {
  static const Dashpot effect;
  return effect;
}

}  // namespace tapfit::effects
