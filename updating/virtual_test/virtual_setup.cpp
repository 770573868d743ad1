#include "updating/virtual_test/virtual_setup.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/samples/anti_alias.hpp"
#include "updating/virtual_test/structure_presets.hpp"
#include "updating/virtual_test/virtual_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

double recorder_rate(double band_end_hz) {
  double rate = 64.0;
  while (acquisition::alias_free_fraction * rate < band_end_hz) rate *= 2.0;
  return rate;
}

acquisition::HammerHand hand_for(const VirtualBundleSpec& spec,
                                 const std::array<double, 2>& band_hz,
                                 double lowest_hz,
                                 double peak_n) {
  acquisition::HammerHand hand;
  hand.hits = spec.hits;
  hand.peak_n = peak_n;
  // Down by some 3 dB at the band's end: a soft tip for a slow structure.
  hand.width_s = 0.6 / band_hz[1];
  // Long enough for the lowest mode to die away, or for patience to end.
  hand.gap_s = spec.gap_s.value_or(
      std::clamp(70.0 / std::max(lowest_hz, band_hz[0]), 0.5, 28.0));
  hand.lead_s = std::min(1.0, hand.gap_s);
  return hand;
}

std::vector<Dof> fixed_sensors(const std::vector<Eigen::Vector3d>& places,
                               const structure::Deck& deck,
                               int component) {
  std::vector<Dof> sensors;
  for (const Eigen::Vector3d& place : places) {
    const auto nearest = std::min_element(
        deck.grids.begin(),
        deck.grids.end(),
        [&](const structure::Grid& a, const structure::Grid& b) {
          return (a.position - place).norm() < (b.position - place).norm();
        });
    sensors.push_back({nearest->id, component, 1});
  }
  return sensors;
}

// The hammer roves and the sensors stay, or the other way round: then the
// hammer hits the first sensor point and the sensors go over the others.
std::vector<VirtualRun> plan_runs(const VirtualBundleSpec& spec,
                                  const TestPoints& points,
                                  const std::vector<std::string>& channels) {
  std::vector<VirtualRun> runs;
  if (!spec.roving_sensor) {
    for (const Dof& hammer : points.others) {
      VirtualRun run{hammer, {}};
      for (std::size_t k = 0; k < points.sensors.size(); ++k) {
        run.sensors.push_back({channels[k], points.sensors[k]});
      }
      runs.push_back(run);
    }
    return runs;
  }
  const std::size_t half = points.others.size() / channels.size();
  for (std::size_t k = 0; k < half; ++k) {
    VirtualRun run{points.sensors.front(), {}};
    for (std::size_t c = 0; c < channels.size(); ++c) {
      run.sensors.push_back({channels[c], points.others[c * half + k]});
    }
    runs.push_back(run);
  }
  return runs;
}

void check_channels(const VirtualBundleSpec& spec,
                    const std::vector<std::string>& channels) {
  for (const VirtualEffect& effect : spec.effects) {
    if (!effect.name.starts_with("channel-") &&
        !effect.name.starts_with("sensor-")) {
      continue;
    }
    if (effect.name == "sensor-mass" && effect.values.size() > 1 &&
        effect.places.empty() && effect.values.size() != channels.size()) {
      throw InputError(fmt::format("{} masses for {} sensors",
                                   effect.values.size(),
                                   channels.size()),
                       effect.name,
                       "Give one mass for all sensors, or one for each.");
    }
    for (const std::string& place : effect.places) {
      // The hammer has no fellow to be swapped with.
      const bool hammer = place == "hammer" &&
                          effect.name.starts_with("channel-") &&
                          effect.name != "channel-swap";
      if (hammer || std::find(channels.begin(), channels.end(), place) !=
                        channels.end()) {
        continue;
      }
      throw InputError(fmt::format("there is no channel '{}' here", place),
                       effect.name,
                       fmt::format("Name one of {}{}.",
                                   effect.name.starts_with("channel-") &&
                                           effect.name != "channel-swap"
                                       ? "hammer, "
                                       : "",
                                   fmt::join(channels, ", ")));
    }
  }
}

/// The band asked for, else the structure's own; checked, in Hz.
std::array<double, 2> band_of(const VirtualBundleSpec& spec,
                              const std::optional<StructurePreset>& preset) {
  if (!preset && !spec.band_hz) {
    throw InputError("a deck needs a band",
                     spec.structure,
                     fmt::format("Give --band LOW HIGH in Hz, or one of {}.",
                                 fmt::join(virtual_structures(), ", ")));
  }
  const std::array<double, 2> band =
      spec.band_hz ? *spec.band_hz : preset->band_hz;
  const std::string asked = fmt::format("--band {} {}", band[0], band[1]);
  if (!(band[0] > 0.0) || !(band[1] > band[0])) {
    throw InputError("the band is no band",
                     asked,
                     "Give the lower frequency first, above 0 Hz.");
  }
  if (band[1] > 1000.0 * band[0]) {
    throw InputError("the band is too wide to be simulated",
                     asked,
                     "Keep its ends within a factor of 1000.");
  }
  return band;
}

/// Frequencies of the model's modes in the band, in Hz; throws when there are
/// none.
std::vector<double> modes_in_band(const VirtualBundleSpec& spec,
                                  const ModelShapes& shapes,
                                  double low_hz) {
  std::vector<double> hz;
  for (const double mode_hz : shapes.frequency_hz) {
    if (mode_hz >= low_hz) hz.push_back(mode_hz);
  }
  if (hz.empty()) {
    throw InputError("the model has no mode in the band",
                     spec.structure,
                     "Choose the band so that some modes lie in it.");
  }
  return hz;
}

}  // namespace

VirtualSetup set_up(const VirtualBundleSpec& spec) {
  VirtualSetup setup;
  const std::optional<StructurePreset> preset = preset_of(spec.structure);
  if (preset && !spec.truth.empty()) {
    throw InputError("a structure with a name has a truth of its own",
                     spec.structure,
                     "Give a deck with --structure, or leave --truth out.");
  }
  setup.band_hz = band_of(spec, preset);
  if (preset) {
    setup.model = preset->model;
    setup.model_cards = preset->cards;
    setup.title = "Virtual hammer test: " + preset->title;
  } else {
    const structure::Deck deck = structure::read_deck(spec.structure);
    setup.model = spec.truth.empty()
                      ? split_twice(deck)
                      : with_truth(deck, structure::read_deck(spec.truth));
    setup.title = "Virtual hammer test of " +
                  std::filesystem::path(spec.structure).filename().string();
  }
  const structure::Deck& deck = setup.model.model;
  setup.component = test_direction(deck);
  setup.sensor_channels = {"acc1", "acc2"};

  const ModelShapes shapes =
      model_shapes(deck, setup.component, setup.band_hz[1]);
  setup.model_hz = modes_in_band(spec, shapes, setup.band_hz[0]);
  TestPoints points = choose_points(
      deck,
      shapes.shapes,
      static_cast<int>(setup.sensor_channels.size()),
      spec.points,
      fixed_sensors(preset ? preset->sensors : std::vector<Eigen::Vector3d>{},
                    deck,
                    setup.component));
  setup.sensor_channels.resize(points.sensors.size());
  check_channels(spec, setup.sensor_channels);
  setup.runs = plan_runs(spec, points, setup.sensor_channels);
  setup.recorder.rate_hz = recorder_rate(setup.band_hz[1]);
  setup.hand = hand_for(spec,
                        setup.band_hz,
                        setup.model_hz.front(),
                        preset ? preset->peak_n : 40.0);
  return setup;
}

}  // namespace tapfit::updating
