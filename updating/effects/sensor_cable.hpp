// The accelerometers' cables: a light spring and damper from each sensor to
// ground, Delta Z = k + s c in the measured direction. They move with a roving
// sensor.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class SensorCable final : public Effect {
 public:
  [[nodiscard]] std::string name() const override { return "sensor-cable"; }
  [[nodiscard]] std::string physics() const override {
    return "the accelerometers' cables; stiffen and damp the lowest modes a "
           "little where the sensors sit";
  }
  /// All sensor channels with cables alike, then each channel alone.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where& where, const Setting& setting) const override;
  [[nodiscard]] std::vector<ActedDof> acts_on(const Where& where,
                                              const Setting& setting,
                                              std::size_t run) const override;
  /// The spring; the damper is not.
  [[nodiscard]] bool is_lossless(std::size_t k) const override {
    return k == 0;
  }
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
