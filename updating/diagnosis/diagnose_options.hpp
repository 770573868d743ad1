// How thoroughly a diagnosis looks, and what it knows of the error.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/estimates.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct DiagnoseOptions {
  int max_rungs = 3;
  int places_per_kind = 3;   ///< of the screened, fitted fully
  int neighbours = 8;        ///< looked at around the best place
  double floor = 0.0;        ///< of the error, from measurement and mesh
  double floor_noise = 0.0;  ///< the measurement's own share of it
  std::string contour;
  std::vector<PropertyName> properties;
  /// As of FitObserver, or empty.
  std::function<void(const Candidate& candidate)> tried = {};
};

}  // namespace tapfit::updating
