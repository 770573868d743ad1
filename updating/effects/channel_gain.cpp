#include "updating/effects/channel_gain.hpp"

#include "updating/effects/sensor_channels.hpp"

#include <fmt/format.h>

namespace tapfit::effects {

std::vector<Where> ChannelGain::places(const Setting& setting) const {
  std::vector<Where> result;
  for (const Where& where : sensor_places(setting)) {
    if (where.channels.size() == 1) result.push_back(where);
  }
  return result;
}

std::vector<ParameterSpec> ChannelGain::parameters(const Where&,
                                                   const Setting&) const {
  // Up to a slip of the unit, g for m/s^2.
  return {{"gain", 1.01, 0.05, 20.0}};
}

std::vector<ActedDof> ChannelGain::acts_on(const Where&,
                                           const Setting&,
                                           std::size_t) const {
  return {};
}

std::complex<double> ChannelGain::law(std::complex<double>,
                                      const std::vector<double>& p,
                                      std::size_t) const {
  return p[0];
}

std::complex<double> ChannelGain::law_derivative(std::complex<double>,
                                                 const std::vector<double>&,
                                                 std::size_t,
                                                 std::size_t) const {
  return 1.0;
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
