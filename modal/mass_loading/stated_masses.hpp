// Masses of sensors as found against those of test.json.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/mode_set/pole_shifts.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::modal {

/// A sensor's mass by what it does to the structure.
struct FoundMass {
  std::vector<std::size_t> channels;  ///< of the sensor
  double kg = 0.0;
  double sd_kg = 0.0;
  std::string by;  ///< what tells it, "how its frequencies move"
};

/// A warning where the sheet's mass is more than three deviations off: of what
/// was found, and of a tenth for cable, glue and mount. Where several channels
/// of a sensor state a mass, it may be that of each of them or of all.
///
/// @return empty where none is stated
[[nodiscard]] std::optional<Finding> stated_mass_finding(
    const acquisition::TestBundle& bundle, const FoundMass& found);

/// The same of masses told by the poles' shifts between set-ups; none where
/// these tell no mass.
[[nodiscard]] std::vector<Finding> stated_mass_findings(
    const acquisition::TestBundle& bundle,
    const std::optional<PoleShifts>& shifts);

}  // namespace tapfit::modal
