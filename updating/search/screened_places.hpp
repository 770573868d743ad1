// What is screened: effects at their locations, and the rows of the base that
// they are felt by.
#pragma once

#include "updating/effects/effect_instance.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/localisation/location_scan.hpp"

#include <vector>

namespace tapfit::updating {

struct ScreenedPlaces {
  /// What may sit at one grid and moves along one axis there.
  struct Kinds {
    std::vector<EffectInstance> simple;
    std::vector<EffectInstance> detailed;  ///< several parameters
  };
  std::vector<Kinds> points;  ///< one for each of the grids scanned
  struct Wide {
    const effects::Effect* effect = nullptr;
    Location where;
  };
  std::vector<Wide> wide;  ///< of the sums scanned
  ScannedPlaces scanned;
};

/// The grids where one point effect may sit.
/// @param model may be asked about any grid
[[nodiscard]] ScreenedPlaces screened_grids(const effects::Effect& effect,
                                            const FrfModel& model,
                                            const Fitter& fitter);

/// All point effects, losses, joints and axial forces of the catalogue.
/// @param model may be asked about any grid
[[nodiscard]] ScreenedPlaces screened_places(const FrfModel& model,
                                             const Fitter& fitter);

}  // namespace tapfit::updating
