#include "updating/effects/dashpot.hpp"

#include "updating/structure/edit/deck_cards.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::effects {

std::vector<ParameterSpec> Dashpot::parameters(const Where&,
                                               const Setting& setting) const {
  // Around the damping that makes the whole mass critically damped.
  const double low = 2.0 * std::numbers::pi * setting.low_hz;
  const double high = 2.0 * std::numbers::pi * setting.high_hz;
  const double lower = 1e-4 * setting.mass_kg * low;
  const double upper = 2.0 * setting.mass_kg * high;
  return {{"damping_ns_per_m", std::sqrt(lower * upper), lower, upper}};
}

std::complex<double> Dashpot::law(std::complex<double> s,
                                  const std::vector<double>& p,
                                  std::size_t) const {
  return s * p[0];
}

std::complex<double> Dashpot::law_derivative(std::complex<double> s,
                                             const std::vector<double>&,
                                             std::size_t,
                                             std::size_t) const {
  return s;
}

std::vector<std::string> Dashpot::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  return ground_damper_cards(
      *setting.deck, 0, where.node, component_of(where, setting), p[0]);
}

}  // namespace tapfit::effects
