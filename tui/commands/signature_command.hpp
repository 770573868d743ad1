// tapfit signature: the missing dynamic stiffness z(s) at one grid, against
// frequency, and how well mass, spring and dashpot explain it.
#pragma once

#include "tui/options/command.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/localisation/signature.hpp"

#include <nlohmann/json_fwd.hpp>

namespace tapfit::tui {

/// {"node", "explained", "laws": {"mass": {"unexplained", "mass_kg"}, ..},
/// "frequency_hz": [..], "z_n_per_m": [[re, im], ..], "z_sd_n_per_m": [..]}
[[nodiscard]] nlohmann::ordered_json signature_json(
    const updating::Signature& signature);
[[nodiscard]] std::string signature_text(const updating::Signature& signature);

/// @throws InputError (also for a grid that the deck does not have), Stopped
[[nodiscard]] std::string signature_command(const CommandOptions& options,
                                            const Progress& progress);

}  // namespace tapfit::tui
