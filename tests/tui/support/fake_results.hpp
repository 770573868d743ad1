// Made-up but consistent results: a cantilevered strip of six grids, two
// sensors, one oscillator per mode.
#pragma once

#include "tui/workbench/workbench.hpp"
#include "updating/localisation/signature.hpp"

#include <vector>

namespace tapfit::tui::testing {

[[nodiscard]] acquisition::TestBundle fake_bundle();
[[nodiscard]] structure::Deck fake_deck();
[[nodiscard]] std::vector<acquisition::Recording> fake_recordings();
[[nodiscard]] acquisition::HitSet fake_hits();
[[nodiscard]] signal::FrfSet fake_frfs();
[[nodiscard]] modal::ModeSet fake_modes();
/// @param high how much too high the model's frequencies are, 0.05 for 5 %
[[nodiscard]] updating::Comparison fake_comparison(double high);
[[nodiscard]] updating::Diagnosis fake_diagnosis();
/// Of that: two changes, the second of which overturns it.
[[nodiscard]] std::vector<updating::Robustness> fake_robustness();
/// A mass of 0.08 kg.
[[nodiscard]] updating::Signature fake_signature(int node);

}  // namespace tapfit::tui::testing
