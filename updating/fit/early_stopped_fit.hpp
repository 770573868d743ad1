// Fits that were ended by hand and kept as they were. The same steps follow
// from the same start, so that their number is all it takes to come to the same
// end again.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/fit/fitter.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct EarlyStoppedFit {
  std::vector<EffectRef> effects;  ///< of the fit, in their order
  int steps = 0;                   ///< taken when it was ended, all stages'

  bool operator==(const EarlyStoppedFit&) const = default;
};

/// Runs a fit and notes where it was ended: Fit::stopped_after.
///
/// @param fit takes its steps under the progress given
/// @param steps after which it is ended; 0: not before its own end
[[nodiscard]] Fit fit_until_stopped(
    const std::function<Fit(const Progress&)>& fit,
    int steps,
    const Progress& progress);

/// "stopped early, after 7 steps"; empty for 0.
[[nodiscard]] std::string stopped_text(int steps);

}  // namespace tapfit::updating
