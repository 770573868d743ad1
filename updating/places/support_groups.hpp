// Which constrained grids are one support: those that element edges join.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>
#include <set>
#include <vector>

namespace tapfit::updating {

/// The grids that an edge of a shell or a bar joins each grid with.
[[nodiscard]] std::map<int, std::set<int>> joined_grids(
    const structure::Deck& deck);

/// Whether all of these lead others by rigid elements and no shell or bar is on
/// them: where they give way, what follows moves as one body.
[[nodiscard]] bool are_hubs(const structure::Deck& deck,
                            const std::vector<int>& nodes);

/// Groups of held grids that element edges or solids connect, each ascending,
/// in the deck's order: of a clamp by a rigid element what follows the grid
/// that is held, and by itself that grid.
[[nodiscard]] std::vector<std::vector<int>> support_groups(
    const structure::Deck& deck);

/// What may give way or be missing together: each of support_groups(), and
/// where there are several that are no hubs, behind them all of these as one.
[[nodiscard]] std::vector<std::vector<int>> support_choices(
    const structure::Deck& deck);

}  // namespace tapfit::updating
