// tapfit mac: two sets of modes against each other, or one against itself.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "modal/mode_set/pairing.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

/// {"points", "mac", "pairs", "comac", "macco"} at the points that both have.
///
/// @param by_hand pairs that stand, counted from 0
/// @throws InputError without a point in common
[[nodiscard]] nlohmann::ordered_json mac_json(
    const modal::ModeSet& first,
    const modal::ModeSet& second,
    const std::vector<modal::Pair>& by_hand);

/// The same for people; of one set alone its AutoMAC.
[[nodiscard]] std::string mac_text(const modal::ModeSet& first,
                                   const modal::ModeSet& second,
                                   const std::vector<modal::Pair>& by_hand);

}  // namespace tapfit::tui
