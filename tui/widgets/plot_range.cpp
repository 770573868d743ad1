#include "tui/widgets/plot_range.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

void zoom(PlotRange& r, double factor, double full_lo, double full_hi) {
  const double centre = r.cursor_set ? r.cursor : 0.5 * (r.lo + r.hi);
  const double full = full_hi - full_lo;
  const double width = std::clamp((r.hi - r.lo) * factor, 1e-4 * full, full);
  r.lo = std::clamp(centre - 0.5 * width, full_lo, full_hi - width);
  r.hi = r.lo + width;
}

void pan(PlotRange& r, double share, double full_lo, double full_hi) {
  const double width = r.hi - r.lo;
  r.lo = std::clamp(r.lo + share * width, full_lo, full_hi - width);
  r.hi = r.lo + width;
}

void move_cursor(PlotRange& r, double step, double full_lo, double full_hi) {
  if (!r.cursor_set) r.cursor = 0.5 * (r.lo + r.hi);
  r.cursor_set = true;
  r.cursor = std::clamp(r.cursor + step, full_lo, full_hi);
  const double width = r.hi - r.lo;
  if (r.cursor < r.lo) r.lo = std::max(full_lo, r.cursor - 0.25 * width);
  if (r.cursor > r.lo + width) {
    r.lo = std::min(full_hi - width, r.cursor - 0.75 * width);
  }
  r.hi = r.lo + width;
}

}  // namespace

PlotRange resolved(const PlotRange& range, double full_lo, double full_hi) {
  PlotRange r = range;
  if (r.whole() || r.hi <= full_lo || r.lo >= full_hi) {
    r.lo = full_lo;
    r.hi = full_hi;
  }
  r.lo = std::max(r.lo, full_lo);
  r.hi = std::min(r.hi, full_hi);
  r.cursor = std::clamp(r.cursor, std::min(full_lo, full_hi), full_hi);
  return r;
}

bool range_key(
    PlotRange& range, Key key, double full_lo, double full_hi, double step) {
  if (!(full_lo < full_hi)) return false;
  PlotRange r = resolved(range, full_lo, full_hi);
  const double move = std::max(0.01 * (r.hi - r.lo), step);
  if (key == U'+' || key == U'=') {
    zoom(r, 0.5, full_lo, full_hi);
  } else if (key == U'-') {
    zoom(r, 2.0, full_lo, full_hi);
  } else if (key == U'[') {
    pan(r, -0.25, full_lo, full_hi);
  } else if (key == U']') {
    pan(r, 0.25, full_lo, full_hi);
  } else if (key == U'_') {
    r.lo = full_lo;
    r.hi = full_hi;
  } else if (key == keys::left || key == U'h') {
    move_cursor(r, -move, full_lo, full_hi);
  } else if (key == keys::right || key == U'l') {
    move_cursor(r, move, full_lo, full_hi);
  } else if (key == U'H') {
    move_cursor(r, -10 * move, full_lo, full_hi);
  } else if (key == U'L') {
    move_cursor(r, 10 * move, full_lo, full_hi);
  } else {
    return false;
  }
  range = r;
  return true;
}

}  // namespace tapfit::tui
