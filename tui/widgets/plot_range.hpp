// The stretch of an axis that is on show: zoom, pan, cursor.
#pragma once

#include "tui/screen/key.hpp"

namespace tapfit::tui {

struct PlotRange {
  double lo = 0.0;  ///< lo >= hi: all there is
  double hi = 0.0;
  double cursor = 0.0;
  bool cursor_set = false;

  [[nodiscard]] bool whole() const { return !(lo < hi); }
};

/// The range to draw when `full_lo` .. `full_hi` is all there is.
[[nodiscard]] PlotRange resolved(const PlotRange& range,
                                 double full_lo,
                                 double full_hi);

/// `+` `-` zoom about the cursor, `[` `]` pan, `_` shows all, Left/Right and
/// h/l move the cursor by 1/100 of the stretch (with `step` > 0 by at least
/// that much).
///
/// @return true when the key was one of these
bool range_key(PlotRange& range,
               Key key,
               double full_lo,
               double full_hi,
               double step = 0.0);

}  // namespace tapfit::tui
