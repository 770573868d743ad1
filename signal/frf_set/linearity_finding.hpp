// What the hits of different force say of a structure: whether its FRFs change
// with the force.
#pragma once

#include <string>

namespace tapfit::signal {

struct LinearityFinding {
  int runs = 0;        ///< with three hits or more, whose levels differ
  double share = 0.0;  ///< of |e|^2 that follows the level, mean over lines
  double share_by_chance = 0.0;  ///< mean over the permutations
  double p_value = 1.0;  ///< of a share this large, were there no dependence
  /// Root mean square change of the FRFs from the weakest hit to the strongest,
  /// each line relative to the FRFs' mean square on it, noise taken off.
  double change = 0.0;
  double level_ratio = 1.0;  ///< strongest over weakest, mean over the runs

  /// Surely not chance, and large enough to matter.
  [[nodiscard]] bool is_nonlinear() const;
};

/// What to tell the user; empty where there is no sign of it.
[[nodiscard]] std::string statement(const LinearityFinding& finding);

}  // namespace tapfit::signal
