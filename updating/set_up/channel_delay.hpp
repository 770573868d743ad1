// One channel late or early against the others (a filter, a multiplexed
// converter, a wireless link): its FRFs turn by exp(-s tau), more at higher
// frequency, and no pole moves. Early is a variant of the place, reported as a
// negative delay.
#pragma once

#include "updating/places/location.hpp"
#include "updating/set_up/channel_effect.hpp"

namespace tapfit::effects {

class ChannelDelay final : public ChannelEffect {
 public:
  [[nodiscard]] std::string name() const override { return "channel-delay"; }
  [[nodiscard]] std::string physics() const override {
    return "a channel that is late or early; the phase turns in proportion to "
           "frequency, no frequency moves";
  }
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::size_t passed_as(const Where& where,
                                      bool hammer) const override;
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
