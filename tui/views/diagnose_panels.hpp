// Below the list of the Diagnose screen: what is missing at the chosen one's
// place, and where that is.
#pragma once

#include "tui/views/diagnose_state.hpp"

#include <optional>
#include <vector>

namespace tapfit::tui {

/// Grids that the place means: its own, those of its channels' sensors, or its
/// elements' corners where there is a deck.
[[nodiscard]] std::vector<int> grids_of(const acquisition::TestBundle& bundle,
                                        const updating::Location& where,
                                        const structure::Deck* deck = nullptr);

/// The grid that the candidate's missing stiffness is drawn of; none where it
/// acts on several, and for a mistake of the set-up, which acts on none.
[[nodiscard]] std::optional<int> signature_grid(
    const acquisition::TestBundle& bundle,
    const updating::Candidate& candidate);

/// The missing dynamic stiffness over frequency, or why there is none to draw.
void draw_signature(Screen& screen,
                    const Rect& rect,
                    const DiagnoseInput& input,
                    const DiagnoseState& state,
                    const updating::Candidate& chosen);

/// The structure with these grids marked.
void draw_place(Screen& screen,
                const Rect& rect,
                const DiagnoseInput& input,
                const DiagnoseState& state,
                const std::vector<int>& grids);

/// Grids by how well each alone explains what is missing: those that come near
/// the best one.
void draw_map(Screen& screen,
              const Rect& rect,
              const DiagnoseInput& input,
              const DiagnoseState& state);

}  // namespace tapfit::tui
