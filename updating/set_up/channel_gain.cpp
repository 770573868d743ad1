// A wrong sensitivity of one channel: its FRFs are multiplied by a real gain at
// every frequency, and no pole moves.
#include "updating/effects/sensor_channels.hpp"
#include "updating/set_up/mistakes.hpp"

#include <fmt/format.h>

namespace tapfit::effects {
namespace {

class ChannelGain final : public Effect {
 public:
  ChannelGain()
      : Effect({.name = "channel-gain",
                .words = "wrong sensitivity of a channel",
                .entry = Entry::Measurement,
                .sits = Sits::OnChannels,
                .law = Law::Own}) {}

  std::vector<Location> places(const TestContext& context) const override {
    return channel_places(context);
  }

  std::vector<ParameterSpec> parameters(const Location&,
                                        const TestContext&) const override {
    // Up to a slip of the unit, g for m/s^2.
    return {{"gain", 1.01, 0.05, 20.0}};
  }

  std::complex<double> law(std::complex<double>,
                           const std::vector<double>& p,
                           std::size_t group) const override {
    return group == 0 ? p[0] : 1.0 / p[0];
  }

  std::complex<double> law_derivative(std::complex<double>,
                                      const std::vector<double>& p,
                                      std::size_t group,
                                      std::size_t) const override {
    return group == 0 ? 1.0 : -1.0 / (p[0] * p[0]);
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext&,
      const std::vector<double>& p) const override {
    return {
        fmt::format("$ Channel {} reads {:.4g} times too much; the model is "
                    "not at fault",
                    where.channels.front(),
                    p[0])};
  }
};

}  // namespace

const Effect& channel_gain() {
  static const ChannelGain effect;
  return effect;
}

}  // namespace tapfit::effects
