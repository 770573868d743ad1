// What the screening finds.
#pragma once

#include "updating/effects/placed_effect.hpp"

namespace tapfit::updating {

/// A hypothesis and what the screening thinks of it.
struct Screened {
  PlacedEffect placed;
  double error = 0.0;  ///< relative FRF error it would leave
  /// What the best law of frequency at its grid would leave, nothing
  /// readjusting; 0: not worked out.
  double any_law = 0.0;
  double places = 1.0;  ///< how many it is the best of
};

}  // namespace tapfit::updating
