// One effect more, at one place, fitted.
#pragma once

#include "updating/fit/fitter.hpp"

#include <vector>

namespace tapfit::updating {

/// A hypothesis, fitted together with everything already in the model.
struct Hypothesis {
  Fit fit;  ///< its own effect is the last one
  /// Logarithm of how likely what it leaves is, by the data that there were for
  /// it to explain (Reach::judged); the fit's own counts all that there may be.
  double log_likelihood = 0.0;
  double places = 1.0;  ///< how many places its kind was searched at
  double log_evidence = 0.0;
  double log_gain = 0.0;  ///< over leaving it out
  std::vector<double> place_sd = {};  ///< of its own effect, see EffectRef

  [[nodiscard]] const EffectInstance& own() const { return fit.effects.back(); }
};

}  // namespace tapfit::updating
