// A matrix as coloured numbers: MAC, or error per FRF and band.
#pragma once

#include "tui/screen/screen.hpp"
#include "tui/widgets/drawing.hpp"

namespace tapfit::tui {

/// How many columns fit into the rectangle.
[[nodiscard]] int fitting_columns(const Rect& rect, const HeatMap& map);

/// Moves what is shown so that the marked entry is among it.
void scroll_to_mark(HeatMap& map, const Rect& rect);

/// 0 for nothing to 6 for `scale` and beyond; 0 for what is not finite.
[[nodiscard]] int heat_of(double value, double scale);

/// Names on the left and above; cut to the rectangle, with an arrow above where
/// columns are left out.
void draw_heat_map(Screen& screen, const Rect& rect, const HeatMap& map);

}  // namespace tapfit::tui
