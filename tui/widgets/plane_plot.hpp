// Curves in a plane with the same scale both ways: circles stay circles.
#pragma once

#include "tui/screen/screen.hpp"
#include "tui/widgets/drawing.hpp"

namespace tapfit::tui {

/// Fitted to the first path (all others are drawn where they fall), with the
/// axes through zero and ticks at the edges. At least 16 x 6 cells, else
/// nothing.
void draw_plane(Screen& screen, const Rect& rect, const PlanePlot& plot);

}  // namespace tapfit::tui
