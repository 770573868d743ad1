// A mass on a spring and damper at one grid (a tuned absorber, a loose cover,
// a battery on rubber), along one axis:
//
//   Delta Z = m s^2 (2 zeta w s + w^2) / (s^2 + 2 zeta w s + w^2)
//
// Well below its own frequency w it is a mass, well above it nearly nothing.
#include "updating/effects/effects.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <cmath>

namespace tapfit::effects {
namespace {

// 2 zeta w s + w^2: spring and damper per unit mass.
std::complex<double> coupling(std::complex<double> s,
                              const std::vector<double>& p) {
  const double w = two_pi * p[1];
  return 2.0 * p[2] * w * s + w * w;
}

class Absorber final : public DirectedEffect {
 public:
  Absorber() : DirectedEffect("absorber", "vibration absorber", Law::Own) {}

  std::vector<ParameterSpec> parameters(
      const Location&, const TestContext& context) const override {
    // Outside the band it is a mass or a ground spring with parameters to
    // spare; heavier than a third of the structure it would be in the model.
    const double m = context.mass_kg;
    return {{"mass_kg", 0.03 * m, 1e-4 * m, 0.35 * m},
            spread("frequency_hz", context.low_hz, context.high_hz),
            {"damping_ratio", 0.02, 5e-4, 0.5}};
  }

  std::complex<double> law(std::complex<double> s,
                           const std::vector<double>& p,
                           std::size_t) const override {
    const std::complex<double> g = coupling(s, p);
    return p[0] * s * s * g / (s * s + g);
  }

  std::complex<double> law_derivative(std::complex<double> s,
                                      const std::vector<double>& p,
                                      std::size_t,
                                      std::size_t k) const override {
    const std::complex<double> g = coupling(s, p);
    const std::complex<double> s2 = s * s;
    if (k == 0) return s2 * g / (s2 + g);
    const double w = two_pi * p[1];
    const std::complex<double> dg =
        k == 1 ? two_pi * (2.0 * p[2] * s + 2.0 * w) : 2.0 * w * s;
    return p[0] * s2 * s2 / ((s2 + g) * (s2 + g)) * dg;
  }

  std::optional<Resonator> resonator(
      const std::vector<double>& p) const override {
    return Resonator{p[0], two_pi * p[1]};
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const override {
    const double w = two_pi * p[1];
    return absorber_cards(*context.deck,
                          where.node,
                          component_of(where, context),
                          p[0],
                          p[0] * w * w,
                          2.0 * p[2] * w * p[0]);
  }
};

}  // namespace

const Effect& absorber() {
  static const Absorber effect;
  return effect;
}

}  // namespace tapfit::effects
