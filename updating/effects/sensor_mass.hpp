// The accelerometers' mass: Delta Z = s^2 m on the three translations of the
// grid where a sensor sits in the run at hand. It moves with a roving sensor.
// Form "rotary": s^2 m h^2 on the three rotations as well, for a body whose
// middle is h above the plate's, 10 mm.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class SensorMass final : public Effect {
 public:
  [[nodiscard]] std::string name() const override { return "sensor-mass"; }
  [[nodiscard]] std::string physics() const override {
    return "the accelerometers' mass; lowers frequencies, moves with a roving "
           "sensor";
  }
  [[nodiscard]] std::vector<std::string> forms() const override {
    return {"each", "rotary"};
  }
  [[nodiscard]] bool takes(const std::string& form,
                           const Where& place,
                           const Setting&) const override {
    return form == "rotary" || place.channels.size() > 1;
  }
  /// All sensor channels sharing one mass, then each channel alone.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
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
  [[nodiscard]] std::vector<Derived> derived(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
