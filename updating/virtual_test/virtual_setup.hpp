// What a virtual test is made of, worked out from its specification: the
// structure twice, band, rate, points, the hand that hits.
#pragma once

#include "acquisition/simulator/hammer_pulse.hpp"
#include "acquisition/simulator/virtual_test.hpp"
#include "updating/virtual_test/virtual_spec.hpp"
#include "updating/virtual_test/virtual_structure.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::updating {

/// One run: who is where.
struct VirtualRun {
  Dof hammer;
  std::vector<VirtualSensor> sensors;
};

struct VirtualSetup {
  std::string title;
  VirtualModel model;
  std::vector<std::string> model_cards;  ///< of model.bdf; empty: see the deck
  int component = 3;
  std::array<double, 2> band_hz{};
  std::vector<double> model_hz;  ///< in the band
  acquisition::VirtualRecorder recorder;
  acquisition::HammerHand hand;
  std::vector<VirtualRun> runs;
  std::vector<std::string> sensor_channels;
};

/// @throws InputError for a structure that is none, a deck without a band, an
///   effect on a channel that is none
[[nodiscard]] VirtualSetup set_up(const VirtualBundleSpec& spec);

}  // namespace tapfit::updating
