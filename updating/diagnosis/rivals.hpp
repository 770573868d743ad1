// The fits that a diagnosis rests on, so that they can be gone on from when
// somebody asks how firm it is: what it found, what came closest in the place
// of each rung, and what came closest on top.
#pragma once

#include "updating/effects/effect_ref.hpp"

#include <vector>

namespace tapfit::updating {

/// A fit as it ended.
struct MadeFit {
  std::vector<EffectRef> effects;          ///< the one in question last
  std::vector<std::vector<double>> sizes;  ///< of each
  std::vector<double> factor;  ///< of each uncertain property, over nominal
  std::vector<double> zeta;    ///< of the first modes
  double zeta_other = 0.01;    ///< of all others
  double places = 1.0;         ///< that its last effect was searched at
  /// Probability of its kind, all places together, over its own.
  double kind_share = 1.0;
};

struct Rivals {
  MadeFit found;  ///< with the whole ladder
  /// For each rung what was fitted in its place: itself, then the best of the
  /// other kinds, the strongest first.
  std::vector<std::vector<MadeFit>> instead = {};
  /// What was fitted on top of the ladder and did not earn a place: the best of
  /// each kind, the strongest first.
  std::vector<MadeFit> besides = {};
};

}  // namespace tapfit::updating
