// Bars that go on in line, as pieces of one member.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::updating {

/// Runs of neighbouring bars along members, each from every bar on either way:
/// at a grid a member goes on with the bar that turns off least, as long as
/// that is a gentle turn (a facet of a curved member).
///
/// @param longest bars of a run
/// @return element ids in the order of the run, two or more; every run once
///   from each of its ends
[[nodiscard]] std::vector<std::vector<int>> bars_in_line(
    const structure::Deck& deck, std::size_t longest);

/// Whole members: every bar with all that go on from it either way, where each
/// of two neighbours goes on with the other.
/// @return element ids, ascending
[[nodiscard]] std::vector<std::vector<int>> whole_runs(
    const structure::Deck& deck);

}  // namespace tapfit::updating
