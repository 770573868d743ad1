// One channel late or early against the others (a filter, a multiplexed
// converter, a wireless link): its FRFs turn by exp(-s tau), more at higher
// frequency, and no pole moves. Early is a variant of the place, reported as a
// negative delay.
#include "updating/effects/sensor_channels.hpp"
#include "updating/set_up/mistakes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::effects {
namespace {

constexpr const char* early = "early";

class ChannelDelay final : public Effect {
 public:
  ChannelDelay()
      : Effect({.name = "channel-delay",
                .words = "delay of a channel",
                .entry = Entry::Measurement,
                .sits = Sits::OnChannels,
                .law = Law::Own}) {}

  std::vector<Location> places(const TestContext& context) const override {
    std::vector<Location> result = channel_places(context);
    const std::size_t late = result.size();
    for (std::size_t k = 0; k < late; ++k) {
      result.push_back(result[k]);
      result.back().variant = early;
    }
    return result;
  }

  // An early sensor turns the phase as a late hammer does.
  std::size_t passed_as(const Location& where, bool hammer) const override {
    return hammer != (where.variant == early) ? 1 : 0;
  }

  std::vector<ParameterSpec> parameters(
      const Location& where, const TestContext& context) const override {
    // From a thousandth of a turn to half a turn at the band's end.
    const double turn = 1.0 / context.high_hz;
    const double sign = where.variant == early ? -1.0 : 1.0;
    return {{"delay_s", 0.02 * turn, 1e-3 * turn, 0.5 * turn, sign}};
  }

  std::complex<double> law(std::complex<double> s,
                           const std::vector<double>& p,
                           std::size_t group) const override {
    return std::exp(group == 0 ? -s * p[0] : s * p[0]);
  }

  std::complex<double> law_derivative(std::complex<double> s,
                                      const std::vector<double>& p,
                                      std::size_t group,
                                      std::size_t) const override {
    return (group == 0 ? -s : s) * law(s, p, group);
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext&,
      const std::vector<double>& p) const override {
    return {
        fmt::format("$ Channel {} is {:.4g} s {}; the model is not at fault",
                    where.channels.front(),
                    p[0],
                    where.variant == early ? early : "late")};
  }
};

}  // namespace

const Effect& channel_delay() {
  static const ChannelDelay effect;
  return effect;
}

}  // namespace tapfit::effects
