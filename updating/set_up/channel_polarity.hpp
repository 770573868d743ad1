// A channel with its sign turned round (a sensor glued upside down, swapped
// leads): its FRFs times -1.
#pragma once

#include "updating/places/location.hpp"
#include "updating/set_up/channel_effect.hpp"

namespace tapfit::effects {

class ChannelPolarity final : public ChannelEffect {
 public:
  [[nodiscard]] std::string name() const override { return "channel-polarity"; }
  [[nodiscard]] std::string physics() const override {
    return "a channel with the wrong sign; half a turn of phase at every "
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
  /// The sensitivity's sign.
  void correct(const Where& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
