#include "updating/effects/added_mass.hpp"

#include "updating/effects/deck_cards.hpp"

namespace tapfit::effects {

std::vector<ParameterSpec> AddedMass::parameters(const Where&,
                                                 const Setting& setting) const {
  // From a washer to as much as the structure itself.
  return {{"mass_kg",
           0.02 * setting.mass_kg,
           1e-5 * setting.mass_kg,
           setting.mass_kg}};
}

std::vector<ActedDof> AddedMass::acts_on(const Where& where,
                                         const Setting&,
                                         std::size_t) const {
  return translations(where.node);
}

std::complex<double> AddedMass::law(std::complex<double> s,
                                    const std::vector<double>& p,
                                    std::size_t) const {
  return s * s * p[0];
}

std::complex<double> AddedMass::law_derivative(std::complex<double> s,
                                               const std::vector<double>&,
                                               std::size_t,
                                               std::size_t) const {
  return s * s;
}

std::vector<std::string> AddedMass::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  return {point_mass_card(*setting.deck, 0, where.node, p[0])};
}

}  // namespace tapfit::effects
