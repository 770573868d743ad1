// What faults of one channel share: a factor on the FRFs that the channel has
// part in, law(s, p, group) with group 0 where it is the response and group 1
// where it is the hammer, by which the FRF is divided.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class ChannelEffect : public Effect {
 public:
  [[nodiscard]] Entry entry() const final { return Entry::Measurement; }
  /// Each sensor channel, then each hammer channel.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] std::vector<ActedDof> acts_on(const Where&,
                                              const Setting&,
                                              std::size_t) const final {
    return {};
  }
};

}  // namespace tapfit::effects
