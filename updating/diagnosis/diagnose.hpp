// Ranks what may be missing from the model and climbs the error ladder: add
// the best, refit everything, look again, stop when nothing earns its place.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/fit/fitter.hpp"

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

/// @param present effects already in the model; their fit is the start
[[nodiscard]] Diagnosis diagnose(const Fitter& fitter,
                                 const std::vector<PlacedEffect>& present,
                                 const DiagnoseOptions& options,
                                 const Progress& progress = {});

}  // namespace tapfit::updating
