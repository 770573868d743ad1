// A mass on a spring and damper at one grid (a tuned absorber, a loose cover,
// a battery on rubber), along one axis:
//
//   Delta Z = m s^2 (2 zeta w s + w^2) / (s^2 + 2 zeta w s + w^2)
//
// Well below its own frequency w it is a mass, well above it nearly nothing.
#pragma once

#include "updating/effects/point_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class Absorber final : public DirectedEffect {
 public:
  [[nodiscard]] std::string name() const override { return "absorber"; }
  [[nodiscard]] std::string physics() const override {
    return "a mass on a spring at one grid; splits the modes near its own "
           "frequency";
  }
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::complex<double> law(std::complex<double> s,
                                         const std::vector<double>& p,
                                         std::size_t group) const override;
  [[nodiscard]] std::complex<double> law_derivative(
      std::complex<double> s,
      const std::vector<double>& p,
      std::size_t group,
      std::size_t k) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
