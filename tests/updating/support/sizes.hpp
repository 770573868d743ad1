// How large a mistake or an effect is made: from just visible to gross.
#pragma once

#include <cmath>

namespace tapfit::updating::testing {

/// Evenly in the logarithm.
/// @param size 0 ... 1
inline double between(double least, double most, double size) {
  return least * std::pow(most / least, size);
}

}  // namespace tapfit::updating::testing
