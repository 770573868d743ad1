// An effect at a place, with the size of its parameters.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <vector>

namespace tapfit::updating {

struct PlacedEffect {
  const effects::Effect* effect = nullptr;
  Where where;
  std::vector<double> p;

  /// What it gives a mode of unit mass, for Entry::Damping.
  [[nodiscard]] effects::ModeDamping mode_damping(double omega) const;
};

/// An effect with its catalogue start values.
[[nodiscard]] PlacedEffect placed(const effects::Effect& effect,
                                  const Where& where,
                                  const effects::Setting& setting);

}  // namespace tapfit::updating
