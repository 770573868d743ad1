#include "updating/effects/absorber.hpp"

#include "acquisition/foundation/constants.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::effects {
namespace {

// 2 zeta w s + w^2: spring and damper per unit mass.
std::complex<double> coupling(std::complex<double> s,
                              const std::vector<double>& p) {
  const double w = two_pi * p[1];
  return 2.0 * p[2] * w * s + w * w;
}

}  // namespace

std::vector<ParameterSpec> Absorber::parameters(const Where&,
                                                const Setting& setting) const {
  // Outside the band it is a mass or a ground spring with parameters to spare;
  // heavier than a third of the structure it would be in the model.
  return {{"mass_kg",
           0.03 * setting.mass_kg,
           1e-4 * setting.mass_kg,
           0.35 * setting.mass_kg},
          {"frequency_hz",
           std::sqrt(setting.low_hz * setting.high_hz),
           setting.low_hz,
           setting.high_hz},
          {"damping_ratio", 0.02, 5e-4, 0.5}};
}

std::complex<double> Absorber::law(std::complex<double> s,
                                   const std::vector<double>& p,
                                   std::size_t) const {
  const std::complex<double> g = coupling(s, p);
  return p[0] * s * s * g / (s * s + g);
}

std::complex<double> Absorber::law_derivative(std::complex<double> s,
                                              const std::vector<double>& p,
                                              std::size_t,
                                              std::size_t k) const {
  const std::complex<double> g = coupling(s, p);
  const std::complex<double> s2 = s * s;
  if (k == 0) return s2 * g / (s2 + g);
  const double w = two_pi * p[1];
  const std::complex<double> dg =
      k == 1 ? two_pi * (2.0 * p[2] * s + 2.0 * w) : 2.0 * w * s;
  return p[0] * s2 * s2 / ((s2 + g) * (s2 + g)) * dg;
}

std::vector<std::string> Absorber::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  const double w = two_pi * p[1];
  return absorber_cards(*setting.deck,
                        where.node,
                        component_of(where, setting),
                        p[0],
                        p[0] * w * w,
                        2.0 * p[2] * w * p[0]);
}

}  // namespace tapfit::effects
