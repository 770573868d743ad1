#include "updating/set_up/channel_delay.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::effects {
namespace {

constexpr const char* early = "early";

}  // namespace

std::vector<Where> ChannelDelay::places(const Setting& setting) const {
  std::vector<Where> result = ChannelEffect::places(setting);
  const std::size_t late = result.size();
  for (std::size_t k = 0; k < late; ++k) {
    result.push_back(result[k]);
    result.back().variant = early;
  }
  return result;
}

// An early sensor turns the phase as a late hammer does.
std::size_t ChannelDelay::passed_as(const Where& where, bool hammer) const {
  return hammer != (where.variant == early) ? 1 : 0;
}

std::vector<ParameterSpec> ChannelDelay::parameters(
    const Where& where, const Setting& setting) const {
  // From a thousandth of a turn to half a turn at the band's end.
  const double turn = 1.0 / setting.high_hz;
  const double sign = where.variant == early ? -1.0 : 1.0;
  return {{"delay_s", 0.02 * turn, 1e-3 * turn, 0.5 * turn, sign}};
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
  return {fmt::format("$ Channel {} is {:.4g} s {}; the model is not at fault",
                      where.channels.front(),
                      p[0],
                      where.variant == early ? early : "late")};
}

}  // namespace tapfit::effects
