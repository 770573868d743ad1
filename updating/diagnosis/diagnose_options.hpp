// How thoroughly a diagnosis looks, and what it knows of the error.
#pragma once

#include "updating/fit/estimates.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

struct DiagnoseOptions {
  int max_rungs = 3;
  int places_per_kind = 3;   ///< of the screened, fitted fully
  int neighbours = 8;        ///< looked at around the best place
  double floor = 0.0;        ///< of the error, from measurement and mesh
  double floor_noise = 0.0;  ///< the measurement's own share of it
  int modes_in_band = 5;
  std::string contour;
  std::vector<PropertyName> properties;
};

}  // namespace tapfit::updating
