// Made-up results of a test with two effects in its model.
#pragma once

#include "tests/tui/support/fake_results.hpp"
#include "tui/report/session_report.hpp"

#include <utility>

namespace tapfit::tui::testing {

/// A mass was added first, then a spring; both were identified anew.
inline ReportData data_of_two_effects() {
  ReportData data;
  data.path = "strip";
  data.date = "2026-11-25";
  data.bundle = fake_bundle();
  data.hits = fake_hits();
  data.frfs = fake_frfs();
  data.modes = fake_modes();
  ModelResults model;
  model.deck = fake_deck();
  model.before = fake_comparison(0.05);
  model.after = fake_comparison(0.0);
  model.diagnosis = fake_diagnosis();
  model.ladder = {{updating::base_rung, {}, 0.388, {}},
                  {"added-mass",
                   {.node = 5},
                   0.1,
                   {{"mass_kg", 0.0666, 0.0006, 0.0654, 0.0678}}},
                  {"ground-spring",
                   {.node = 6},
                   0.038,
                   {{"stiffness_n_per_m", 412.0, 3.0, 406.0, 418.0}}}};
  model.diagnosis->ladder.push_back(model.ladder.back());
  model.parameters = {
      {"E:1", 7.07e10, 2.0e8, 7.03e10, 7.11e10, "Pa"},
      {"added-mass mass_kg", 0.0785, 0.0006, 0.0773, 0.0797},
      {"ground-spring stiffness_n_per_m", 412.0, 3.0, 406.0, 418.0}};
  data.model = std::move(model);
  return data;
}

}  // namespace tapfit::tui::testing
