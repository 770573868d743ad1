// The fits that a diagnosis rests on, made again from where they ended: with
// all that it found, without each of it, with what came closest in the place of
// each, and with what came closest on top. Nothing is searched for.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/search/hypotheses.hpp"
#include "updating/diagnosis/rivals.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/robustness/setting_change.hpp"

#include <vector>

namespace tapfit::updating {

/// A hypothesis beside others.
struct Contender {
  Hypothesis hypothesis;
  double kind_share = 1.0;  ///< see MadeFit
};

struct Refits {
  Fit found;
  std::vector<Fit> without;  ///< each rung
  /// Of each rung: what was found, its own effect last, then its rivals.
  std::vector<std::vector<Contender>> instead;
  std::vector<Contender> besides;
};

/// With nothing changed.
[[nodiscard]] Refits refits_of(const Rivals& rivals,
                               const Fitter& fitter,
                               const Progress& progress);

/// The same under a change.
/// @param fitter with the changed setting
[[nodiscard]] Refits refits_under(const SettingChange& change,
                                  const Refits& unchanged,
                                  const Fitter& fitter,
                                  const Progress& progress);

}  // namespace tapfit::updating
