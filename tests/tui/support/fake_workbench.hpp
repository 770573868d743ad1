// A workbench with made-up results, so that the program can be driven without
// reading a recording. Its base model is 5 % too high.
#pragma once

#include "tests/tui/support/fake_results.hpp"
#include "tui/workbench/workbench.hpp"
#include "updating/session/added_effect.hpp"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace tapfit::tui::testing {

struct FakeOptions {
  std::vector<updating::AddedEffect> left_with = {};  ///< effects from before
  bool model = true;
  bool ready_frfs = false;  ///< no recordings
  bool hits_fail = false;   ///< hits() throws InputError
  bool unreadable = false;  ///< the second run
  bool hitless = false;     ///< the second run
  /// Effects that another window adds and saves before the first save here.
  std::vector<updating::AddedEffect> other_window = {};
  std::string unsaved = {};           ///< what save() answers
  bool endless_modes = false;         ///< modes() runs until it is stopped
  bool diagnosed_before = false;      ///< the base, by an earlier run
  bool diagnosed_on_the_way = false;  ///< and with any number of effects
  /// The first diagnosis tells what it has tried and goes on without an end.
  bool endless_first_diagnosis = false;
  bool endless_diagnosis = false;  ///< the same once something was added
  /// How many candidates each diagnosis tells it has tried, once something was
  /// added.
  std::size_t tried_after_adding = 0;
  /// diagnosis() waits while it is set, once something was added.
  std::atomic<bool>* diagnosis_held = nullptr;
  bool reversed_after_adding = false;  ///< candidates, the last one first
  std::atomic<bool>* held = nullptr;   ///< add_together() waits while it is set
  std::string add_fails = {};          ///< what add_together() throws
};

[[nodiscard]] std::unique_ptr<Workbench> fake_workbench(
    const FakeOptions& options = {});

}  // namespace tapfit::tui::testing
