#include "updating/measurement/frf_runs.hpp"

#include <map>
#include <string>

namespace tapfit::updating {
namespace {

// Of sensors that stayed the point's name without its sign, "12Z"; of one that
// moved "sensor Z".
std::string channel_name(const Dof& dof, Sensors sensors) {
  std::string name = tapfit::name(dof);
  name.pop_back();
  return sensors == Sensors::Moved ? std::string("sensor ") + name.back()
                                   : name;
}

acquisition::Channel hammer() {
  acquisition::Channel channel;
  channel.name = "hammer";
  channel.quantity = acquisition::Quantity::Force;
  return channel;
}

}  // namespace

void lay_out_runs(signal::FrfSet& set,
                  acquisition::TestBundle& bundle,
                  Sensors sensors) {
  bundle.channels = {hammer()};
  bundle.runs.clear();
  std::map<std::string, std::size_t> channels;
  std::map<std::pair<Dof, int>, std::size_t> runs;
  for (signal::Frf& frf : set.frfs) {
    const auto [channel, new_channel] = channels.try_emplace(
        channel_name(frf.response, sensors), bundle.channels.size());
    if (new_channel) {
      bundle.channels.emplace_back();
      bundle.channels.back().name = channel->first;
    }
    const int place = sensors == Sensors::Moved ? frf.response.node : 0;
    const auto [run, new_run] =
        runs.try_emplace({frf.reference, place}, bundle.runs.size());
    if (new_run) {
      bundle.runs.emplace_back();
      bundle.runs.back().hammer = {0, frf.reference};
    }
    frf.channel = channel->second;
    frf.run = run->second;
    bundle.runs[frf.run].sensors.push_back({frf.channel, frf.response});
  }
}

}  // namespace tapfit::updating
