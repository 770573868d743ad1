// A factor of the model that is fitted along with what is uncertain.
#pragma once

#include <string>

namespace tapfit::updating {

/// Of what an engineer's model is off by, see corrections.hpp.
struct Correction {
  std::string name;
  double sd = 0.0;  ///< of ln f, before anything is measured
  double mean = 0.0;
  double lower = -1.0;
  double upper = 1.0;
};

}  // namespace tapfit::updating
