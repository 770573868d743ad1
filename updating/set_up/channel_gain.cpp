#include "updating/set_up/channel_gain.hpp"

#include <fmt/format.h>

namespace tapfit::effects {

std::vector<ParameterSpec> ChannelGain::parameters(const Where&,
                                                   const Setting&) const {
  // Up to a slip of the unit, g for m/s^2.
  return {{"gain", 1.01, 0.05, 20.0}};
}

std::complex<double> ChannelGain::law(std::complex<double>,
                                      const std::vector<double>& p,
                                      std::size_t group) const {
  return group == 0 ? p[0] : 1.0 / p[0];
}

std::complex<double> ChannelGain::law_derivative(std::complex<double>,
                                                 const std::vector<double>& p,
                                                 std::size_t group,
                                                 std::size_t) const {
  return group == 0 ? 1.0 : -1.0 / (p[0] * p[0]);
}

std::vector<std::string> ChannelGain::bulk_data(
    const Where& where, const Setting&, const std::vector<double>& p) const {
  return {
      fmt::format("$ Channel {} reads {:.4g} times too much; the model is "
                  "not at fault",
                  where.channels.front(),
                  p[0])};
}

}  // namespace tapfit::effects
