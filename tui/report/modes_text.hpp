// Modes as JSON and as text.
#pragma once

#include "modal/mode_set/mode_set.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

/// "0.440 ± 0.010", in per cent; "–" where none was given.
[[nodiscard]] std::string damping_words(const modal::Mode& mode,
                                        int digits = 2);

/// "0.998"; "–" of a mode without a shape.
[[nodiscard]] std::string mpc_words(const modal::Mode& mode);

/// {"modes": [{"frequency_hz", "damping_ratio", "mpc", "mpd_deg", "cluster",
/// "shape", "shape_sd"}], "unrefined_error", "synthesis_error", "warnings"}
/// and, where sensors move between set-ups, "pole_shifts".
[[nodiscard]] nlohmann::ordered_json modes_json(
    const modal::ModeSet& modes, const std::vector<std::string>& channels = {});

/// Frequencies and damping with their standard deviations, and the MPC; what
/// moves the poles between set-ups.
[[nodiscard]] std::string modes_text(
    const modal::ModeSet& modes, const std::vector<std::string>& channels = {});

}  // namespace tapfit::tui
