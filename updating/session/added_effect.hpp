// An effect that was added to the model.
#pragma once

#include "updating/effects/effect_ref.hpp"

namespace tapfit::updating {

/// One that is off stays in the list.
struct AddedEffect {
  EffectRef ref;
  bool on = true;
  bool together = false;  ///< in one step with the one before it

  bool operator==(const AddedEffect&) const = default;
};

}  // namespace tapfit::updating
