// A spring from one grid to ground: Delta Z = k along one axis.
#pragma once

#include "updating/effects/point_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class GroundSpring final : public DirectedEffect {
 public:
  [[nodiscard]] std::string name() const override { return "ground-spring"; }
  [[nodiscard]] std::string physics() const override {
    return "a spring from one grid to ground; raises frequencies, the same "
           "stiffness at every frequency";
  }
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] bool is_lossless(std::size_t) const override { return true; }
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
