// An identified parameter as a result.
#pragma once

#include <string>
#include <vector>

namespace tapfit::updating {

struct Estimate {
  std::string name;  ///< for example "mass_kg"; ends in its unit
  double value = 0.0;
  double sd = 0.0;
  double lo95 = 0.0;
  double hi95 = 0.0;
  std::string unit = {};  ///< where the name does not end in it
  bool at_bound = false;  ///< the fit would go on: the interval is one-sided
};

/// "mass_kg 0.0785 +- 0.0006, ..."
[[nodiscard]] std::string parameters_text(
    const std::vector<Estimate>& parameters);

}  // namespace tapfit::updating
