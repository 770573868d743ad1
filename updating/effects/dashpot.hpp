// A viscous damper from one grid to ground: Delta Z = s c in the measured
// direction.
#pragma once

#include "updating/effects/point_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class Dashpot final : public DirectedEffect {
 public:
  [[nodiscard]] std::string name() const override { return "dashpot"; }
  [[nodiscard]] std::string physics() const override {
    return "a damper from one grid to ground; widens peaks where the grid "
           "moves, "
           "leaves frequencies";
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
