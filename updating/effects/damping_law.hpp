// One law for the damping of every mode, in place of a ratio for each: viscous
// in proportion to mass and stiffness (Rayleigh) and structural,
//
//   2 zeta omega = alpha + beta omega^2 + eta omega.
//
// Structural damping is taken as the viscous one that takes as much energy from
// a mode at its own frequency, zeta = eta / 2.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class DampingLaw final : public Effect {
 public:
  [[nodiscard]] std::string name() const override { return "damping-law"; }
  [[nodiscard]] std::string physics() const override {
    return "the damping of all modes by one law: viscous with mass and "
           "stiffness, structural";
  }
  [[nodiscard]] Entry entry() const override { return Entry::Damping; }
  [[nodiscard]] std::vector<Where> places(const Setting&) const override {
    return {Where{}};
  }
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<ActedDof> acts_on(const Where&,
                                              const Setting&,
                                              std::size_t) const override {
    return {};
  }
  [[nodiscard]] std::complex<double> law(std::complex<double>,
                                         const std::vector<double>&,
                                         std::size_t) const override {
    return 0.0;
  }
  [[nodiscard]] std::complex<double> law_derivative(
      std::complex<double>,
      const std::vector<double>&,
      std::size_t,
      std::size_t) const override {
    return 0.0;
  }
  [[nodiscard]] ModeDamping mode_damping(double omega,
                                         std::size_t k) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
