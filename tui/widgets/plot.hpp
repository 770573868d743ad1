// The room tui/widgets. What screens are put together from: plots, tables,
// bars, heat maps, the wireframe.
// In:  Numbers and a rectangle.
// Out: Cells in a screen.
// May include: its row in CONTRIBUTING.md.
//
// Line plots in cells: axes with ticks and units, linear or logarithmic,
// several curves, bands around them, shaded stretches, markers and a cursor.
#pragma once

#include "tui/screen/screen.hpp"
#include "tui/widgets/drawing.hpp"
#include "tui/widgets/ticks.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// Axes with their ranges filled in: never empty, always finite, positive on
/// a logarithmic axis (at most 8 decades), a constant curve in the middle.
struct Ranges {
  Axis x;
  Axis y;
};
[[nodiscard]] Ranges fit_ranges(const Plot& plot);

/// About so many; those of degrees are parts of a turn.
[[nodiscard]] std::vector<Tick> axis_ticks(const Axis& axis, int count);

/// Draws into the rectangle; at least 12 x 4 cells, else nothing.
void draw_plot(Screen& screen, const Rect& rect, const Plot& plot);

/// "f 12.5 Hz: measured 3.21, model 2.98 (m/s²)/N": what lies under x, each
/// curve at its point nearest to x; curves without a value are left out.
[[nodiscard]] std::string read_out(const Plot& plot, double x);

}  // namespace tapfit::tui
