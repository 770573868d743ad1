// A mass fixed to one grid: Delta Z = s^2 m on its three translations. The
// variant "rotary" has an inertia as well, s^2 J on its three rotations: a body
// that is large against the wavelength, or stands off.
#pragma once

#include "updating/effects/point_effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class AddedMass final : public PointEffect {
 public:
  [[nodiscard]] std::string name() const override { return "added-mass"; }
  [[nodiscard]] std::string physics() const override {
    return "a mass at one grid; lowers frequencies, grows with frequency "
           "squared, the same in every run";
  }
  [[nodiscard]] std::vector<std::string> forms() const override {
    return {"rotary"};
  }
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  /// Where it turns, not farther out than twice the side of a cube of plastic.
  [[nodiscard]] bool is_plausible(const Where& where,
                                  const std::vector<double>& p) const override;
  [[nodiscard]] std::vector<ActedDof> acts_on(const Where& where,
                                              const Setting& setting,
                                              std::size_t run) const override;
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
