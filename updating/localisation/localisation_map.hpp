// How well each grid, as the one place where something is missing, explains
// what the model lacks.
#pragma once

#include "updating/fit/fitter.hpp"

#include <vector>

namespace tapfit::updating {

struct GridShare {
  int node = 0;
  double explained = 0.0;  ///< share of the discrepancy, 0..1
};

/// Every grid that a point effect may sit at, the best first. The law of
/// frequency is free at each line: where, whatever it is.
[[nodiscard]] std::vector<GridShare> localisation_map(const Fit& current,
                                                      const Target& target,
                                                      const Progress& progress);

}  // namespace tapfit::updating
