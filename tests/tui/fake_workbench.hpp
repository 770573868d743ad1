// A workbench with made-up but consistent results, so that the program can be
// driven without reading a recording: a cantilevered strip of six grids, two
// sensors, one oscillator per mode. Its base model is 5 % too high.
#pragma once

#include "tui/workbench.hpp"

#include <memory>
#include <string>
#include <vector>

namespace tapfit::tui::testing {

struct FakeOptions {
  std::vector<updating::AddedEffect> left_with = {};  ///< effects from before
  bool model = true;
  bool hits_fail = false;      ///< hits() throws InputError
  std::string unsaved = {};    ///< what save() answers
  bool endless_modes = false;  ///< modes() runs until it is stopped
};

[[nodiscard]] acquisition::TestBundle fake_bundle();
[[nodiscard]] structure::Deck fake_deck();
[[nodiscard]] std::vector<acquisition::Recording> fake_recordings();
[[nodiscard]] acquisition::HitSet fake_hits();
[[nodiscard]] signal::FrfSet fake_frfs();
[[nodiscard]] modal::ModeSet fake_modes();
/// @param high how much too high the model's frequencies are, 0.05 for 5 %
[[nodiscard]] updating::Comparison fake_comparison(double high);
[[nodiscard]] updating::Diagnosis fake_diagnosis();
/// A mass of 0.08 kg.
[[nodiscard]] updating::Signature fake_signature(int node);

[[nodiscard]] std::unique_ptr<Workbench> fake_workbench(
    const FakeOptions& options = {});

}  // namespace tapfit::tui::testing
