// A channel with its sign turned round (a sensor glued upside down, swapped
// leads): its FRFs times -1.
#include "updating/effects/sensor_channels.hpp"
#include "updating/set_up/mistakes.hpp"

#include <fmt/format.h>

namespace tapfit::effects {
namespace {

class ChannelPolarity final : public Effect {
 public:
  ChannelPolarity()
      : Effect({.name = "channel-polarity",
                .words = "wrong polarity of a channel",
                .entry = Entry::Measurement,
                .sits = Sits::OnChannels,
                .law = Law::Own}) {}

  std::vector<Location> places(const TestContext& context) const override {
    return channel_places(context);
  }

  std::complex<double> law(std::complex<double>,
                           const std::vector<double>&,
                           std::size_t) const override {
    return -1.0;
  }

  // The sensitivity's sign.
  void correct(const Location& where,
               const acquisition::TestBundle&,
               acquisition::TestBundle& sheet) const override {
    for (acquisition::Channel& channel : sheet.channels) {
      const bool own = channel.name == where.channels.front();
      if (own) channel.sensitivity = -channel.sensitivity;
    }
  }

  std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext&,
      const std::vector<double>&) const override {
    return {
        fmt::format("$ Channel {} has the wrong sign; the model is not at "
                    "fault",
                    where.channels.front())};
  }
};

}  // namespace

const Effect& channel_polarity() {
  static const ChannelPolarity effect;
  return effect;
}

}  // namespace tapfit::effects
