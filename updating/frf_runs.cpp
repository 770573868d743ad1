#include "updating/frf_runs.hpp"

#include <map>
#include <string>

namespace tapfit::updating {
namespace {

// "12Z": the point's name without its sign.
std::string channel_name(const Dof& dof) {
  std::string name = tapfit::name(dof);
  name.pop_back();
  return name;
}

}  // namespace

void lay_out_runs(signal::FrfSet& set, acquisition::TestBundle& bundle) {
  acquisition::Channel hammer;
  hammer.name = "hammer";
  hammer.quantity = acquisition::Quantity::Force;
  bundle.channels = {hammer};
  bundle.runs.clear();
  std::map<std::string, std::size_t> channels;
  std::map<Dof, std::size_t> runs;
  for (signal::Frf& frf : set.frfs) {
    const auto [channel, new_channel] = channels.try_emplace(
        channel_name(frf.response), bundle.channels.size());
    if (new_channel) {
      bundle.channels.emplace_back();
      bundle.channels.back().name = channel->first;
    }
    const auto [run, new_run] =
        runs.try_emplace(frf.reference, bundle.runs.size());
    if (new_run) {
      bundle.runs.emplace_back();
      bundle.runs.back().hammer = {0, frf.reference};
    }
    frf.channel = channel->second;
    frf.run = run->second;
    bundle.runs[frf.run].sensors.push_back({frf.channel, frf.response});
  }
  set.statements.emplace_back(
      "the FRFs came ready: which sensor was where is not in the file, so that "
      "each response point counts as a sensor that stayed there");
}

}  // namespace tapfit::updating
