// tapfit frf --free: the measured FRFs without the sensors' mass.
#pragma once

#include "signal/mass_removal/sensor_loads.hpp"
#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

/// One --free as written: CHANNEL or POINT, [=KG][,sd=KG].
struct FreeWord {
  std::string what;
  std::optional<double> kg;
  double sd_kg = 0.0;
};

/// @return empty when the text is none
[[nodiscard]] std::optional<FreeWord> parse_free(const std::string& text);

/// The masses that words name, where they sit. "all" is every channel whose
/// mass the bundle states; a channel without a mass has the bundle's; a point
/// ("12Z=0.02") is a mass that stays there in all runs.
///
/// @throws InputError for a name that is none, a mass that is not known, words
///   that mix channels and points
[[nodiscard]] signal::LoadedTest masses_to_free(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& frfs,
    const std::vector<std::string>& words);

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
