#include "updating/effects/channel_delay.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::effects {

std::vector<ParameterSpec> ChannelDelay::parameters(
    const Where&, const Setting& setting) const {
  // From a thousandth of a turn to half a turn at the band's end.
  const double turn = 1.0 / setting.high_hz;
  return {{"delay_s", 0.02 * turn, 1e-3 * turn, 0.5 * turn}};
}

std::complex<double> ChannelDelay::law(std::complex<double> s,
                                       const std::vector<double>& p,
                                       std::size_t group) const {
  return std::exp(group == 0 ? -s * p[0] : s * p[0]);
}

std::complex<double> ChannelDelay::law_derivative(std::complex<double> s,
                                                  const std::vector<double>& p,
                                                  std::size_t group,
                                                  std::size_t) const {
  return (group == 0 ? -s : s) * law(s, p, group);
}

std::vector<std::string> ChannelDelay::bulk_data(
    const Where& where, const Setting&, const std::vector<double>& p) const {
  return {
      fmt::format("$ Channel {} is {:.4g} s late; the model is not at fault",
                  where.channels.front(),
                  p[0])};
}

}  // namespace tapfit::effects
