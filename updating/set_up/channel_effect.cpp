#include "updating/set_up/channel_effect.hpp"

#include "updating/effects/sensor_channels.hpp"

#include <set>

namespace tapfit::effects {

std::vector<Where> ChannelEffect::places(const Setting& setting) const {
  std::vector<Where> result;
  for (const Where& where : sensor_places(setting)) {
    if (where.channels.size() == 1) result.push_back(where);
  }
  std::set<std::size_t> hammers;
  for (const acquisition::Run& run : setting.bundle->runs) {
    hammers.insert(run.hammer.channel);
  }
  for (const std::size_t channel : hammers) {
    Where where;
    where.channels = {setting.bundle->channels[channel].name};
    result.push_back(where);
  }
  return result;
}

}  // namespace tapfit::effects
