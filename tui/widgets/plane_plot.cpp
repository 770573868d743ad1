#include "tui/widgets/plane_plot.hpp"

#include "tui/screen/text.hpp"
#include "tui/widgets/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

/// From the plane to dots: one unit is as long both ways.
struct Mapping {
  double x_0 = 0.0;    ///< at the body's left edge
  double y_0 = 0.0;    ///< at its upper edge
  double scale = 1.0;  ///< dots across per unit
  double flat = 1.0;   ///< dots down per dot across

  [[nodiscard]] double x(double v) const { return (v - x_0) * scale; }
  [[nodiscard]] double y(double v) const { return (y_0 - v) * scale * flat; }
};

struct Extent {
  double lo = 0.0;
  double hi = 0.0;
  bool found = false;

  void take(const Eigen::VectorXd& values) {
    for (const double v : values) {
      if (!std::isfinite(v)) continue;
      lo = found ? std::min(lo, v) : v;
      hi = found ? std::max(hi, v) : v;
      found = true;
    }
  }
  [[nodiscard]] double middle() const { return 0.5 * (lo + hi); }
  [[nodiscard]] double span() const { return hi - lo; }
};

Mapping fitted(const PlanePlot& plot, const Dots& dots) {
  Extent x;
  Extent y;
  if (!plot.paths.empty()) {
    x.take(plot.paths.front().x);
    y.take(plot.paths.front().y);
  }
  Mapping at;
  at.flat = dots.flatness();
  const double width = dots.width() - 1;
  const double height = (dots.height() - 1) / at.flat;
  const double span_x = x.span() > 0.0 ? x.span() : 1.0;
  const double span_y = y.span() > 0.0 ? y.span() : 1.0;
  at.scale = 0.9 * std::min(width / span_x, height / span_y);
  at.x_0 = x.middle() - 0.5 * width / at.scale;
  at.y_0 = y.middle() + 0.5 * height / at.scale;
  return at;
}

void draw_axes(Dots& dots, const Mapping& at) {
  const Pen pen{Colour::Grey, Pattern::Dotted, '.', true};
  const double w = dots.width() - 1;
  const double h = dots.height() - 1;
  dots.line(0.0, at.y(0.0), w, at.y(0.0), pen);
  dots.line(at.x(0.0), 0.0, at.x(0.0), h, pen);
}

void draw_path(Dots& dots, const Mapping& at, const Path& path) {
  const Eigen::Index n = std::min(path.x.size(), path.y.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = at.x(path.x[i]);
    const double y = at.y(path.y[i]);
    const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0);
    if (path.joined) {
      dots.line(at.x(path.x[before]), at.y(path.y[before]), x, y, path.pen);
    } else {
      dots.spot(x, y, path.pen);
    }
  }
}

struct Body {
  Rect rect;
  int dots_x;  ///< dots per cell
  int dots_y;
};

void draw_ticks(Screen& screen, const Body& body, const Mapping& at) {
  const Style dim{.colour = Colour::Grey};
  const Rect& b = body.rect;
  const double x_end = at.x_0 + b.width * body.dots_x / at.scale;
  int last = b.x - 1;
  for (const Tick& t : ticks(at.x_0, x_end, false, std::max(2, b.width / 10))) {
    const int column = b.x + static_cast<int>(at.x(t.value)) / body.dots_x;
    const int start = column - text_width(t.label) / 2;
    if (start <= last || start + text_width(t.label) > b.x + b.width) continue;
    last = screen.text(start, b.y + b.height, t.label, dim);
  }
  const double y_end = at.y_0 - b.height * body.dots_y / at.scale / at.flat;
  for (const Tick& t : ticks(y_end, at.y_0, false, std::max(2, b.height / 3))) {
    const int row = b.y + static_cast<int>(at.y(t.value)) / body.dots_y;
    if (row < b.y || row >= b.y + b.height) continue;
    screen.text_right(b.x, row, t.label, dim, 8);
  }
}

void draw_spots(Screen& screen,
                const Body& body,
                const Mapping& at,
                const std::vector<PlaneSpot>& spots) {
  const Rect& b = body.rect;
  for (const PlaneSpot& spot : spots) {
    if (!std::isfinite(spot.x + spot.y)) continue;
    const int column =
        b.x + static_cast<int>(std::floor(at.x(spot.x) / body.dots_x));
    const int row =
        b.y + static_cast<int>(std::floor(at.y(spot.y) / body.dots_y));
    if (!b.holds(column, row)) continue;
    screen.put(column, row, spot.glyph, spot.style);
    screen.text(
        column + 1, row, spot.label, spot.style, b.x + b.width - column - 1);
  }
}

}  // namespace

void draw_plane(Screen& screen, const Rect& rect, const PlanePlot& plot) {
  if (rect.width < 16 || rect.height < 6) return;
  keep_drawing(screen, plot);
  const Style dim{.colour = Colour::Grey};
  int x = screen.text(rect.x, rect.y, plot.y_label, dim, rect.width);
  x = screen.text(
      x + 2, rect.y, plot.title, {.bold = true}, rect.x + rect.width - x - 2);
  const Rect inner{rect.x + 8, rect.y + 1, rect.width - 9, rect.height - 3};
  Dots dots(inner.width, inner.height, screen);
  const Body body{inner, dots.across(), dots.down()};
  const Mapping at = fitted(plot, dots);
  draw_axes(dots, at);
  for (const Path& path : plot.paths) draw_path(dots, at, path);
  dots.draw(screen, body.rect.x, body.rect.y);
  draw_ticks(screen, body, at);
  screen.text_right(rect.x + rect.width,
                    rect.y + rect.height - 1,
                    plot.x_label,
                    dim,
                    rect.width);
  draw_spots(screen, body, at, plot.spots);
}

}  // namespace tapfit::tui
