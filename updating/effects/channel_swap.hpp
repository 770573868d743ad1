// Two sensor channels with their cables (or their names) swapped: each recorded
// what the other should have.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class ChannelSwap final : public Effect {
 public:
  [[nodiscard]] std::string name() const override { return "channel-swap"; }
  [[nodiscard]] std::string physics() const override {
    return "two channels swapped; poles are right, each sensor's shape is the "
           "other's";
  }
  [[nodiscard]] Entry entry() const override { return Entry::Measurement; }
  /// Every two sensor channels that measure at the same time.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where&, const Setting&) const override {
    return {};
  }
  [[nodiscard]] std::vector<ActedDof> acts_on(const Where&,
                                              const Setting&,
                                              std::size_t) const override {
    return {};
  }
  [[nodiscard]] std::string recorded_as(const std::string& channel,
                                        const Where& where) const override;
  /// No factor on the FRFs themselves.
  [[nodiscard]] std::complex<double> law(std::complex<double>,
                                         const std::vector<double>&,
                                         std::size_t) const override {
    return 1.0;
  }
  [[nodiscard]] std::complex<double> law_derivative(
      std::complex<double>,
      const std::vector<double>&,
      std::size_t,
      std::size_t) const override {
    return 0.0;
  }
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
