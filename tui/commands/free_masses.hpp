// tapfit frf --free: the measured FRFs without the sensors' mass.
#pragma once

#include "signal/mass_removal/sensor_loads.hpp"
#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

/// As frf_json, with "freed" ("measurement", "modes", "no need", "no"),
/// "reason" and "measured_sd_percent" for each FRF, and the "masses".
[[nodiscard]] nlohmann::ordered_json freed_json(
    const signal::FrfSet& measured,
    const signal::FreedFrfs& freed,
    const std::vector<signal::KnownMass>& masses);

[[nodiscard]] std::string freed_text(
    const signal::FrfSet& measured,
    const signal::FreedFrfs& freed,
    const std::vector<signal::KnownMass>& masses);

/// The output of `tapfit frf --free`. With --uff writes the FRFs that are free
/// of the masses.
/// @throws InputError, Stopped
[[nodiscard]] std::string free_masses(updating::Session& session,
                                      const CommandOptions& options,
                                      const Progress& progress);

}  // namespace tapfit::tui
