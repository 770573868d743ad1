#include "updating/virtual_test/virtual_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tapfit::updating {
namespace {

// What was written down of two swapped channels: each at the other's place.
void swap_channels(const VirtualEffect& effect,
                   acquisition::TestBundle& bundle) {
  for (acquisition::Run& run : bundle.runs) {
    std::vector<Dof*> places;
    for (acquisition::Placement& sensor : run.sensors) {
      const std::string& name = bundle.channels[sensor.channel].name;
      if (std::find(effect.places.begin(), effect.places.end(), name) !=
          effect.places.end()) {
        places.push_back(&sensor.dof);
      }
    }
    if (places.size() == 2) std::swap(*places[0], *places[1]);
  }
}

// A point that is roved over is written down at another grid.
void write_wrong_grid(const VirtualEffect& effect,
                      bool roving_sensor,
                      acquisition::TestBundle& bundle) {
  const std::vector<int> grids = effect.numbers();
  const auto write = [&grids](acquisition::Placement& point) {
    if (point.dof.node == grids[0]) point.dof.node = grids[1];
  };
  for (acquisition::Run& run : bundle.runs) {
    if (!roving_sensor) {
      write(run.hammer);
      continue;
    }
    std::for_each(run.sensors.begin(), run.sensors.end(), write);
  }
}

}  // namespace

std::string recording_name(int run) {
  return fmt::format("run-{:02}.flac", run);
}

acquisition::TestBundle test_sheet(const VirtualBundleSpec& spec,
                                   const VirtualSetup& setup,
                                   std::vector<acquisition::Channel> channels,
                                   const std::filesystem::path& folder) {
  acquisition::TestBundle bundle;
  bundle.folder = folder;
  bundle.title = setup.title;
  bundle.deck = folder / "model.bdf";
  bundle.channels = std::move(channels);
  bundle.band_hz = setup.band_hz;
  if (!setup.model.model.materials.empty()) {
    bundle.uncertain.push_back(
        {"material", setup.model.model.materials.begin()->first, "E", 3.0});
  }
  for (std::size_t k = 0; k < setup.runs.size(); ++k) {
    acquisition::Run run;
    run.file = folder / recording_name(static_cast<int>(k) + 1);
    run.hammer = {0, setup.runs[k].hammer};
    std::size_t channel = 0;
    for (const VirtualSensor& sensor : setup.runs[k].sensors) {
      run.sensors.push_back({++channel, sensor.dof});
    }
    bundle.runs.push_back(run);
  }
  for (const VirtualEffect& effect : spec.effects) {
    if (effect.name == "channel-swap") swap_channels(effect, bundle);
    if (effect.name == "wrong-grid") {
      write_wrong_grid(effect, spec.roving_sensor, bundle);
    }
  }
  return bundle;
}

}  // namespace tapfit::updating
