// What a verdict assumed, changed one thing at a time: each prior halved and
// doubled, each uncertain property held at the deck's value, what a careful
// deck is allowed to be wrong by in form halved and doubled, each run left out,
// or each group of runs where there are many.
#pragma once

#include "updating/fit/estimates.hpp"
#include "updating/fit/fitter.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::updating {

struct SettingChange {
  std::string what = {};                   ///< "prior of E:1 doubled"
  std::vector<std::size_t> of = {};        ///< in FitProblem::uncertain_sd
  double prior = 1.0;                      ///< times the sd of these
  double damping_prior = 1.0;              ///< times the sd of damping
  bool held = false;                       ///< these stay at the deck's value
  double form = 1.0;                       ///< times the allowance for form
  std::vector<std::size_t> left_out = {};  ///< runs, counted from 0

  /// Whether fits end elsewhere; else only what is said of them changes.
  [[nodiscard]] bool moves_fits() const;
};

/// All of them, in the order above; of a test that consists of modes without
/// damping and runs.
/// @param properties names of the first in FitProblem::uncertain_sd; others
///   there are the mesh's, and are changed together
[[nodiscard]] std::vector<SettingChange> setting_changes(
    const FitProblem& problem, const std::vector<PropertyName>& properties);

[[nodiscard]] FitProblem changed(FitProblem problem,
                                 const SettingChange& change);

}  // namespace tapfit::updating
