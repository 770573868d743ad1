#include "updating/effects/channel_swap.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace tapfit::effects {

std::vector<Where> ChannelSwap::places(const Setting& setting) const {
  std::set<std::pair<std::size_t, std::size_t>> together;
  for (const acquisition::Run& run : setting.bundle->runs) {
    for (const acquisition::Placement& a : run.sensors) {
      for (const acquisition::Placement& b : run.sensors) {
        if (a.channel < b.channel) together.insert({a.channel, b.channel});
      }
    }
  }
  std::vector<Where> result;
  for (const auto& [a, b] : together) {
    Where where;
    where.channels = {setting.bundle->channels[a].name,
                      setting.bundle->channels[b].name};
    result.push_back(where);
  }
  return result;
}

std::string ChannelSwap::recorded_as(const std::string& channel,
                                     const Where& where) const {
  if (channel == where.channels.front()) return where.channels.back();
  if (channel == where.channels.back()) return where.channels.front();
  return channel;
}

std::vector<std::string> ChannelSwap::bulk_data(
    const Where& where, const Setting&, const std::vector<double>&) const {
  return {
      fmt::format("$ Channels {} and {} are swapped; the model is not at "
                  "fault",
                  where.channels.front(),
                  where.channels.back())};
}

}  // namespace tapfit::effects
