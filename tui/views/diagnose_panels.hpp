// Below the list of the Diagnose screen: what is missing at the chosen one's
// place, and where that is.
#pragma once

#include "tui/views/diagnose_view.hpp"

#include <vector>

namespace tapfit::tui {

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
