// What the screening found that is worth a full fit, kind after kind.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/search/reach.hpp"
#include "updating/search/screened.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace tapfit::updating {

struct HypothesisOptions {
  int places_per_kind = 3;
  int neighbours = 8;
  /// Only places whose screened error is within this factor of the least.
  double promising = 1e300;
  /// An error that leaves nothing to explain: what is there for show needs no
  /// other forms.
  double explained = 0.0;
  int joints = 0;  ///< of the screened places, where more than places_per_kind
  /// One of them that is fitted already, as its last effect: others are looked
  /// at more closely only where they may do as well. None: null.
  const Fit* known = nullptr;
  /// Of other effects, which these must come near as well. None: null.
  const Fit* rival = nullptr;
  /// The best of each kind is fitted to the end whether it comes near or not.
  bool best_of_each = true;
  /// Told of each that was fitted nearly to the end, and again of what was to
  /// the end, one at a time; or empty.
  std::function<void(const Fit& fit)> tried = {};
};

/// What is worth a full fit of one kind.
struct Planned {
  const effects::Effect* effect = nullptr;
  std::vector<EffectInstance> tries;
  const Fit* known = nullptr;  ///< one of them, fitted already
  /// One base for all; a change of the stiffness needs one of its own.
  std::shared_ptr<const FrfModel> shared;
};

/// Whether a fit has an effect already: the same again, another loss of the
/// same elements, or a form of the same.
[[nodiscard]] bool is_present(const Fit& current,
                              const EffectInstance& candidate);

/// @param screened the least error first
/// @param reach of what is known beforehand
[[nodiscard]] std::vector<Planned> planned_fits(
    const Fit& current,
    const std::vector<Screened>& screened,
    const Fitter& fitter,
    const HypothesisOptions& options,
    const Reach& reach);

}  // namespace tapfit::updating
