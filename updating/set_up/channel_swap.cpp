// Two sensor channels with their cables (or their names) swapped: each recorded
// what the other should have.
#include "updating/set_up/mistakes.hpp"
#include "updating/set_up/sheet_mistake.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace tapfit::effects {
namespace {

class ChannelSwap final : public SheetMistake {
 public:
  ChannelSwap()
      : SheetMistake({.name = "channel-swap",
                      .words = "two channels swapped",
                      .entry = Entry::Measurement,
                      .sits = Sits::OnChannels,
                      .law = Law::Own}) {}

  // Every two sensor channels that measure at the same time.
  std::vector<Location> places(const TestContext& context) const override {
    std::set<std::pair<std::size_t, std::size_t>> together;
    for (const acquisition::Run& run : context.bundle->runs) {
      for (const acquisition::Placement& a : run.sensors) {
        for (const acquisition::Placement& b : run.sensors) {
          if (a.channel < b.channel) together.insert({a.channel, b.channel});
        }
      }
    }
    std::vector<Location> result;
    for (const auto& [a, b] : together) {
      result.push_back({.channels = {context.bundle->channels[a].name,
                                     context.bundle->channels[b].name}});
    }
    return result;
  }

  // In each run in which both measure.
  void correct(const Location& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override {
    for (std::size_t r = 0; r < written.runs.size(); ++r) {
      const std::vector<acquisition::Placement>& sensors =
          written.runs[r].sensors;
      const auto sensor_on = [&](const std::string& channel) {
        const auto it =
            std::ranges::find_if(sensors, [&](const acquisition::Placement& p) {
              return written.channels[p.channel].name == channel;
            });
        return static_cast<std::size_t>(it - sensors.begin());
      };
      const std::size_t a = sensor_on(where.channels.front());
      const std::size_t b = sensor_on(where.channels.back());
      if (std::max(a, b) >= sensors.size()) continue;
      std::vector<acquisition::Placement>& real = sheet.runs[r].sensors;
      std::swap(real[a].dof, real[b].dof);
    }
  }
};

}  // namespace

const Effect& channel_swap() {
  static const ChannelSwap effect;
  return effect;
}

}  // namespace tapfit::effects
