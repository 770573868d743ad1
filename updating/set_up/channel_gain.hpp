// A wrong sensitivity of one channel: its FRFs are multiplied by a real gain at
// every frequency, and no pole moves.
#pragma once

#include "updating/places/location.hpp"
#include "updating/set_up/channel_effect.hpp"

namespace tapfit::effects {

class ChannelGain final : public ChannelEffect {
 public:
  [[nodiscard]] std::string name() const override { return "channel-gain"; }
  [[nodiscard]] std::string physics() const override {
    return "a wrong sensitivity; one factor at every frequency, no frequency "
           "moves";
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
