// How the last fit came about: convergence, correlations, the L-curve.
#pragma once

#include "tui/screen/screen.hpp"
#include "updating/fit/live_fit.hpp"
#include "updating/fit/update_record.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// Error over the steps, and below it every parameter relative to where it
/// ended.
void draw_convergence(Screen& screen,
                      const Rect& rect,
                      const updating::UpdateRecord& record);

/// |correlation| of the estimates in %, and what the data cannot tell apart.
/// @param look_alikes of the effect, in words; empty: it has none
void draw_correlation(Screen& screen,
                      const Rect& rect,
                      const updating::UpdateRecord& record,
                      const std::string& look_alikes);

/// ||x|| over ||S x - d||, both logarithmic, with its corner; or why there is
/// none.
void draw_l_curve(Screen& screen,
                  const Rect& rect,
                  const updating::UpdateRecord& record);

/// A fit that runs still: its parameters with their bounds, its error step by
/// step, and a curve sliding onto the measurement where there is room.
void draw_live_fit(Screen& screen,
                   const Rect& rect,
                   const std::vector<double>& errors,
                   const updating::LiveFit& live);

}  // namespace tapfit::tui
