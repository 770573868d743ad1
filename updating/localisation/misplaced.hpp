// A point that was elsewhere than it was written down.
#pragma once

#include "acquisition/foundation/dof.hpp"

#include <string>

namespace tapfit::updating {

/// A point that was elsewhere than it was written down.
struct Misplaced {
  std::string channel;  ///< the sensor's; empty: hit points
  Dof written;
  Dof likely;                ///< where its FRFs fit
  double error = 0.0;        ///< of its FRFs where it was written down
  double error_there = 0.0;  ///< and where it is likely to have been
};

}  // namespace tapfit::updating
