// What the screening finds.
#pragma once

#include "updating/effects/effect_instance.hpp"

namespace tapfit::updating {

/// What an effect must lower the error to, as a share of what it was. Mesh and
/// model form leave errors of a few percent that some effect can always shave a
/// little.
inline constexpr double worth_it = 0.85;

/// A hypothesis and what the screening thinks of it.
struct Screened {
  EffectInstance placed;
  double error = 0.0;  ///< relative FRF error it would leave
  /// What the best law of frequency at its grid would leave, nothing
  /// readjusting; 0: not worked out.
  double any_law = 0.0;
  double places = 1.0;  ///< how many it is the best of
};

}  // namespace tapfit::updating
