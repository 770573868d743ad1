#include "updating/effects/ground_spring.hpp"

#include "updating/effects/suspension.hpp"
#include "updating/structure/edit/deck_cards.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::effects {

std::vector<ParameterSpec> GroundSpring::parameters(
    const Where& where, const Setting& setting) const {
  // Stiffness that the structure's own mass has at the band's two ends.
  const double low = 2.0 * std::numbers::pi * setting.low_hz;
  const double high = 2.0 * std::numbers::pi * setting.high_hz;
  double lower = 1e-4 * setting.mass_kg * low * low;
  double upper = 10.0 * setting.mass_kg * high * high;
  if (setting.suspension) {
    const ActedDof at = motion_of(where, component_of(where, setting), setting);
    upper = std::min(upper,
                     stiffest_spring(*setting.suspension, at, *setting.deck));
    lower = std::min(lower, 1e-4 * upper);
  }
  return {{"stiffness_n_per_m", std::sqrt(lower * upper), lower, upper}};
}

std::complex<double> GroundSpring::law(std::complex<double>,
                                       const std::vector<double>& p,
                                       std::size_t) const {
  return p[0];
}

std::complex<double> GroundSpring::law_derivative(std::complex<double>,
                                                  const std::vector<double>&,
                                                  std::size_t,
                                                  std::size_t) const {
  return 1.0;
}

std::vector<std::string> GroundSpring::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  return ground_spring_cards(
      *setting.deck, 0, where.node, component_of(where, setting), p[0]);
}

}  // namespace tapfit::effects
