#include "tui/widgets/plot.hpp"

#include "tui/screen/layout.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::tui {
namespace {

using Index = Eigen::Index;

struct Span {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();

  void take(double v, bool log) {
    if (!std::isfinite(v) || (log && v <= 0.0)) return;
    lo = std::min(lo, v);
    hi = std::max(hi, v);
  }
};

/// A usable range out of whatever was found.
void settle(Axis& axis, Span span) {
  if (!(span.lo <= span.hi)) span = {axis.log ? 0.1 : 0.0, 1.0};
  if (axis.log) {
    span.lo = std::max(span.lo, span.hi * 1e-8);
    const double room = std::pow(span.hi / span.lo, 0.05);
    axis.lo = span.lo / std::max(room, 1.02);
    axis.hi = span.hi * std::max(room, 1.02);
    if (axis.hi / axis.lo < 1.2) {
      axis.lo /= 2.0;
      axis.hi *= 2.0;
    }
    return;
  }
  double room = 0.05 * (span.hi - span.lo);
  const double size = std::max(std::abs(span.lo), std::abs(span.hi));
  if (room <= 1e-12 * size || room == 0.0) room = size > 0 ? 0.5 * size : 0.5;
  axis.lo = span.lo - room;
  axis.hi = span.hi + room;
}

bool given(const Axis& axis) {
  return std::isfinite(axis.lo) && std::isfinite(axis.hi) &&
         axis.lo < axis.hi && (!axis.log || axis.lo > 0.0);
}

void take_visible(Span& span, const Curve& curve, const Axis& x, bool log) {
  const auto take = [&](const Eigen::VectorXd& values) {
    const Index n = std::min(values.size(), curve.x.size());
    for (Index i = 0; i < n; ++i) {
      const double at = curve.x[i];
      if (at >= x.lo && at <= x.hi) span.take(values[i], log);
    }
  };
  take(curve.y);
  // A band may dip towards zero on a logarithmic axis; the curve decides.
  if (log && curve.y.size() > 0) return;
  take(curve.low);
  take(curve.high);
}

/// Position along the axis, 0 at lo and 1 at hi; not finite off a log axis.
double along(const Axis& axis, double v) {
  if (!axis.log) return (v - axis.lo) / (axis.hi - axis.lo);
  if (!(v > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log(v / axis.lo) / std::log(axis.hi / axis.lo);
}

struct Frame {
  Rect body;  ///< the cells of the curves
  Ranges ranges;
  std::vector<Tick> y_ticks;
};

int column_of(const Frame& frame, double x) {
  const double t = along(frame.ranges.x, x);
  if (!(t >= 0.0 && t <= 1.0)) return -1;
  return frame.body.x +
         static_cast<int>(std::lround(t * (frame.body.width - 1)));
}

int row_of(const Frame& frame, double y) {
  const double t = along(frame.ranges.y, y);
  if (!(t >= 0.0 && t <= 1.0)) return -1;
  return frame.body.y +
         static_cast<int>(std::lround((1.0 - t) * (frame.body.height - 1)));
}

Frame lay_out(const Rect& rect, const Plot& plot) {
  Frame frame;
  frame.ranges = fit_ranges(plot);
  const int rows = rect.height - 1 - (plot.x_labels ? 2 : 0);
  const Axis& y = frame.ranges.y;
  frame.y_ticks =
      axis_ticks(y, y.unit == "deg" ? (rows + 1) / 2 : std::max(2, rows / 3));
  int margin = 5;
  for (const Tick& tick : frame.y_ticks) {
    margin = std::max(margin, text_width(tick.label));
  }
  margin = std::min(margin, 8);
  frame.body = {rect.x + margin + 1,
                rect.y + 1,
                std::max(rect.width - margin - 2, 1),
                std::max(rows, 1)};
  return frame;
}

void draw_y_axis(Screen& screen, const Frame& frame) {
  const Rect& b = frame.body;
  const Style dim{.colour = Colour::Grey};
  for (int y = b.y; y < b.y + b.height; ++y) screen.put(b.x - 1, y, U'│', dim);
  for (const Tick& tick : frame.y_ticks) {
    const int y = row_of(frame, tick.value);
    if (y < 0) continue;
    screen.put(b.x - 1, y, U'┤', dim);
    screen.text_right(b.x - 1, y, tick.label, dim, 8);
  }
}

void draw_x_axis(Screen& screen, const Frame& frame) {
  const Rect& b = frame.body;
  const Style dim{.colour = Colour::Grey};
  const Axis& x = frame.ranges.x;
  const int y = b.y + b.height;
  screen.put(b.x - 1, y, U'└', dim);
  for (int i = 0; i < b.width; ++i) screen.put(b.x + i, y, U'─', dim);
  const std::string unit =
      x.label + (x.unit.empty() ? "" : fmt::format(" [{}]", x.unit));
  const int room = b.x + b.width - text_width(unit);
  screen.text_right(b.x + b.width, y + 1, unit, dim, b.width);
  int last = b.x - 8;
  for (const Tick& t : ticks(x.lo, x.hi, x.log, std::max(2, b.width / 10))) {
    const int column = column_of(frame, t.value);
    if (column < 0) continue;
    screen.put(column, y, U'┴', dim);
    const int width = text_width(t.label);
    const int start = std::max(column - width / 2, b.x - 1);
    if (start <= last + 1 || start + width >= room) continue;
    screen.text(start, y + 1, t.label, dim);
    last = start + width;
  }
}

/// Axes go from the first dot to the last; in pixels from the middle of the
/// first cell to that of the last, where glyphs and clicks have them.
struct DotScale {
  const Frame& frame;
  const Dots& dots;

  [[nodiscard]] double x(double v) const {
    const double t = along(frame.ranges.x, v);
    return dots.in_pixels() ? middle(t, frame.body.width, dots.across())
                            : t * (dots.width() - 1);
  }
  [[nodiscard]] double y(double v) const {
    const double t = 1.0 - along(frame.ranges.y, v);
    return dots.in_pixels() ? middle(t, frame.body.height, dots.down())
                            : t * (dots.height() - 1);
  }

 private:
  static double middle(double t, int cells, int dots_of_cell) {
    return (t * (cells - 1) + 0.5) * dots_of_cell - 0.5;
  }
};

/// The first index at or left of the visible stretch, and one behind it.
std::pair<Index, Index> visible(const Curve& curve, const Axis& x) {
  const double* begin = curve.x.data();
  const double* end = begin + curve.x.size();
  const Index from = std::lower_bound(begin, end, x.lo) - begin;
  const Index to = std::upper_bound(begin, end, x.hi) - begin;
  return {std::max<Index>(from - 1, 0),
          std::min<Index>(to + 1, curve.x.size())};
}

void draw_band(Dots& dots, const DotScale& at, const Curve& curve) {
  const Index n = std::min(curve.low.size(), curve.high.size());
  const auto [from, to] = visible(curve, at.frame.ranges.x);
  Pen pen = curve.pen;
  const bool around = curve.y.size() > 0;  // a band, not an envelope
  pen.dim = around;
  if (around) pen.mark = '.';
  double last = std::numeric_limits<double>::quiet_NaN();
  for (Index i = from; i < std::min(to, n); ++i) {
    const double x = at.x(curve.x[i]);
    if (!std::isfinite(x)) continue;
    const double apart = 2.0 * dots.grain();
    if (around && std::isfinite(last) && std::round(x) < last + apart) continue;
    last = std::round(x);
    const double bottom = at.frame.ranges.y.lo;
    const double low =
        at.frame.ranges.y.log ? std::max(curve.low[i], bottom) : curve.low[i];
    if (around) pen.pattern = Pattern::Dotted;
    dots.line(x, at.y(low), x, at.y(curve.high[i]), pen);
  }
}

void draw_curve(Dots& dots, const DotScale& at, const Curve& curve) {
  const auto [from, to] = visible(curve, at.frame.ranges.x);
  const Index n = std::min({to, curve.y.size(), curve.x.size()});
  for (Index i = from; i < n; ++i) {
    const double x = at.x(curve.x[i]);
    const double y = at.y(curve.y[i]);
    if (!curve.joined || n - from == 1) {
      dots.spot(x, y, curve.pen);
    } else if (i == from) {
      dots.line(x, y, x, y, curve.pen);
    } else {
      dots.line(at.x(curve.x[i - 1]), at.y(curve.y[i - 1]), x, y, curve.pen);
    }
  }
}

void draw_title(Screen& screen, const Rect& rect, const Plot& plot) {
  const std::string unit =
      plot.y.unit.empty() ? plot.y.label
                          : fmt::format("{} [{}]", plot.y.label, plot.y.unit);
  int x =
      screen.text(rect.x, rect.y, unit, {.colour = Colour::Grey}, rect.width);
  if (!plot.title.empty()) {
    x = screen.text(
        x + 2, rect.y, plot.title, {.bold = true}, rect.x + rect.width - x - 2);
  }
  const int end = rect.x + rect.width;
  int unnamed = 0;
  for (const Curve& curve : plot.curves) {
    if (curve.label.empty()) continue;
    if (x + text_width(curve.label) + 5 > end) {
      ++unnamed;
      continue;
    }
    const Style style{.colour = curve.pen.colour};
    const char32_t mark = screen.ascii() ? static_cast<char32_t>(curve.pen.mark)
                          : curve.pen.pattern == Pattern::Solid  ? U'━'
                          : curve.pen.pattern == Pattern::Dashed ? U'╌'
                                                                 : U'┈';
    screen.put(x + 2, rect.y, mark, style);
    x = screen.text(x + 4, rect.y, curve.label, style);
  }
  if (unnamed == 0 || x + 4 > end) return;
  screen.text(x + 2,
              rect.y,
              fmt::format("+{}", unnamed),
              {.colour = Colour::Grey},
              end - x - 2);
}

void draw_below_curves(Screen& screen, const Frame& frame, const Plot& plot) {
  const Rect& b = frame.body;
  const Axis& x = frame.ranges.x;
  for (const Shade& shade : plot.shades) {
    const int from = column_of(frame, std::clamp(shade.from, x.lo, x.hi));
    const int to = column_of(frame, std::clamp(shade.to, x.lo, x.hi));
    if (shade.to < x.lo || shade.from > x.hi || from < 0 || to < 0) continue;
    screen.fill({from, b.y, to - from + 1, b.height}, U'░', shade.style);
  }
  if (!plot.cursor) return;
  const int column = column_of(frame, *plot.cursor);
  if (column < 0) return;
  for (int y = b.y; y < b.y + b.height; ++y) {
    screen.put(column, y, U'│', {.colour = Colour::Yellow});
  }
}

/// The same where curves can lie over it.
void draw_below_curves(Dots& dots, const DotScale& at, const Plot& plot) {
  const Axis& x = at.frame.ranges.x;
  for (const Shade& shade : plot.shades) {
    if (shade.to < x.lo || shade.from > x.hi) continue;
    dots.shade(at.x(std::max(shade.from, x.lo)),
               at.x(std::min(shade.to, x.hi)),
               shade.style.colour);
  }
  if (!plot.cursor || *plot.cursor < x.lo || *plot.cursor > x.hi) return;
  const double cursor = at.x(*plot.cursor);
  dots.line(cursor, 0.0, cursor, dots.height(), {.colour = Colour::Yellow});
}

void draw_above_curves(Screen& screen, const Frame& frame, const Plot& plot) {
  for (const Spot& spot : plot.spots) {
    const int column = column_of(frame, spot.x);
    const int row = row_of(frame, spot.y);
    if (column >= 0 && row >= 0)
      screen.put(column, row, spot.glyph, spot.style);
  }
  for (const Marker& marker : plot.markers) {
    const int column = column_of(frame, marker.x);
    if (column >= 0)
      screen.put(column, frame.body.y, marker.glyph, marker.style);
  }
}

}  // namespace

Ranges fit_ranges(const Plot& plot) {
  Ranges ranges{plot.x, plot.y};
  if (!given(ranges.x)) {
    Span span;
    for (const Curve& curve : plot.curves) {
      for (const double v : curve.x) span.take(v, plot.x.log);
    }
    for (const Spot& spot : plot.spots) span.take(spot.x, plot.x.log);
    if (span.lo < span.hi) {
      ranges.x.lo = span.lo;
      ranges.x.hi = span.hi;
    } else {
      settle(ranges.x, span);
    }
  }
  if (!given(ranges.y)) {
    Span span;
    for (const Curve& curve : plot.curves) {
      take_visible(span, curve, ranges.x, plot.y.log);
    }
    for (const Spot& spot : plot.spots) span.take(spot.y, plot.y.log);
    settle(ranges.y, span);
  }
  return ranges;
}

std::vector<Tick> axis_ticks(const Axis& axis, int count) {
  return axis.unit == "deg" ? degree_ticks(axis.lo, axis.hi, count)
                            : ticks(axis.lo, axis.hi, axis.log, count);
}

void draw_plot(Screen& screen, const Rect& rect, const Plot& plot) {
  if (rect.width < 12 || rect.height < (plot.x_labels ? 4 : 2)) return;
  keep_drawing(screen, plot);
  const Frame frame = lay_out(rect, plot);
  draw_title(screen, rect, plot);
  draw_y_axis(screen, frame);
  if (plot.x_labels) draw_x_axis(screen, frame);
  Dots dots(frame.body.width, frame.body.height, screen);
  const DotScale at{frame, dots};
  if (dots.in_pixels()) {
    draw_below_curves(dots, at, plot);
  } else {
    draw_below_curves(screen, frame, plot);
  }
  for (const Curve& curve : plot.curves) {
    if (curve.low.size() > 0) draw_band(dots, at, curve);
  }
  for (const Curve& curve : plot.curves) draw_curve(dots, at, curve);
  dots.draw(screen, frame.body.x, frame.body.y);
  draw_above_curves(screen, frame, plot);
  const Axis& x = frame.ranges.x;
  screen.zone({.rect = frame.body,
               .kind = Zone::Kind::PlotX,
               .from = x.lo,
               .to = x.hi,
               .log = x.log});
}

std::string read_out(const Plot& plot, double x) {
  std::string values;
  double shown = x;
  for (const Curve& curve : plot.curves) {
    if (curve.x.size() == 0 || curve.y.size() != curve.x.size()) continue;
    Index nearest = 0;
    (curve.x.array() - x).abs().minCoeff(&nearest);
    if (!std::isfinite(curve.y[nearest])) continue;
    if (values.empty()) shown = curve.x[nearest];
    values += fmt::format("{}{} {}",
                          values.empty() ? "" : ", ",
                          curve.label,
                          number(curve.y[nearest], 4));
  }
  if (values.empty()) return {};
  return fmt::format(
      "{} {}: {} {}", number(shown, 5), plot.x.unit, values, plot.y.unit);
}

}  // namespace tapfit::tui
