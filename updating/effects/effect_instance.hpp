// An effect at a place, with the size of its parameters.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <vector>

namespace tapfit::updating {

struct EffectInstance {
  const effects::Effect* effect = nullptr;
  Location where;
  std::vector<double> p;
  std::vector<double> place_sd = {};  ///< see EffectRef

  /// What it gives a mode of unit mass, for Entry::Damping.
  [[nodiscard]] effects::ModeDamping mode_damping(double omega) const;
};

/// An effect with its catalogue start values.
[[nodiscard]] EffectInstance placed(const effects::Effect& effect,
                                    const Location& where,
                                    const effects::TestContext& context);

}  // namespace tapfit::updating
