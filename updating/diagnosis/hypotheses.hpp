// The explanations worth a full fit: the best of each kind that the screening
// found, their neighbours, and every place of the kinds with few places.
#pragma once

#include "updating/diagnosis/worth_fitting.hpp"
#include "updating/fit/fitter.hpp"

#include <vector>

namespace tapfit::updating {

/// A hypothesis, fitted together with everything already in the model.
struct Hypothesis {
  Fit fit;              ///< its own effect is the last one
  double places = 1.0;  ///< how many places its kind was searched at
  double log_evidence = 0.0;
  /// Of the logarithms of its own parameters, for not knowing its place better;
  /// empty where it was not looked at.
  std::vector<double> place_sd = {};

  [[nodiscard]] const PlacedEffect& own() const { return fit.effects.back(); }
};

/// @return fitted hypotheses, kind after kind; their evidence is not set
[[nodiscard]] std::vector<Hypothesis> fit_hypotheses(
    const Fit& current,
    const Fitter& fitter,
    const HypothesisOptions& options,
    const Progress& progress);

}  // namespace tapfit::updating
