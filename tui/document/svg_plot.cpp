#include "tui/document/svg_plot.hpp"

#include "tui/document/svg_line.hpp"
#include "tui/screen/text.hpp"
#include "tui/widgets/plot.hpp"
#include "tui/widgets/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tapfit::tui {
namespace {

constexpr double left_margin = 62.0;
constexpr double right_margin = 14.0;
constexpr double bottom_margin = 44.0;
constexpr double legend_height = 24.0;
constexpr double title_height = 20.0;
constexpr double top_margin = 8.0;

/// Axes with their ranges; six decades show what there is to see.
Ranges shown_ranges(const Plot& plot) {
  Ranges ranges = fit_ranges(plot);
  const bool found = !(plot.y.lo < plot.y.hi);
  if (found && ranges.y.log) {
    ranges.y.lo = std::max(ranges.y.lo, 1e-6 * ranges.y.hi);
  }
  return ranges;
}

std::string axis_title(const Axis& axis) {
  return axis.unit.empty() ? axis.label
                           : fmt::format("{} [{}]", axis.label, axis.unit);
}

Stroke pen_stroke(const Pen& pen) {
  return {pen.dim ? ink::pale : ink_of(pen.colour),
          pen.dim ? 1.0 : 1.4,
          pen.pattern == Pattern::Solid    ? ""
          : pen.pattern == Pattern::Dashed ? "6 3"
                                           : "2 2"};
}

/// A dot for each point.
Stroke dots_of(const Pen& pen) {
  return {ink_of(pen.colour), pen.dim ? 2.6 : 4.0, "", true};
}

/// "1e-05" to "10⁻⁵"; others as they are.
std::string tick_label(const std::string& label) {
  static constexpr const char* digits[] = {
      "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t e = label.find('e');
  if (e == std::string::npos) return label;
  std::string text = label.substr(0, e);
  text = text == "1" ? "10" : text + "·10";
  std::string power = label.substr(e + 1);
  if (power.starts_with('-')) text += "⁻";
  power.erase(0, power.find_first_not_of("+-0"));
  for (const char c : power) {
    if (c >= '0' && c <= '9') text += digits[c - '0'];
  }
  return text;
}

void draw_axes(SvgCanvas& canvas,
               const Axis& x,
               const Axis& y,
               const Frame& f) {
  const Stroke grid{ink::pale, 0.7};
  const Scale to_x(x, f.left, f.right);
  const Scale to_y(y, f.bottom, f.top);
  for (const Tick& tick : axis_ticks(x, 8)) {
    const auto at = to_x(tick.value);
    if (!at) continue;
    canvas.line(*at, f.top, *at, f.bottom, grid);
    canvas.text(*at,
                f.bottom + 16.0,
                tick_label(tick.label),
                {.anchor = "middle", .size = 12.0});
  }
  for (const Tick& tick : axis_ticks(y, 6)) {
    const auto at = to_y(tick.value);
    if (!at) continue;
    canvas.line(f.left, *at, f.right, *at, grid);
    canvas.text(f.left - 6.0,
                *at + 4.0,
                tick_label(tick.label),
                {.anchor = "end", .size = 12.0});
  }
  canvas.rectangle(
      f.left, f.top, f.right - f.left, f.bottom - f.top, "none", ink::grey);
  canvas.text((f.left + f.right) / 2.0,
              f.bottom + 36.0,
              axis_title(x),
              {.anchor = "middle"});
  canvas.text(14.0,
              (f.top + f.bottom) / 2.0,
              axis_title(y),
              {.anchor = "middle", .turn_deg = -90.0});
}

/// What is drawn in a frame, from values to pixels.
struct Paper {
  SvgCanvas& canvas;
  Frame frame;
  Scale to_x;
  Scale to_y;
};

void draw_line(const Paper& on,
               const Eigen::VectorXd& x,
               const Eigen::VectorXd& y,
               const Pen& pen,
               bool joined) {
  const std::string d = joined ? line_path(on.frame, on.to_x, on.to_y, x, y)
                               : dotted_path(on.frame, on.to_x, on.to_y, x, y);
  if (!d.empty()) on.canvas.path(d, joined ? pen_stroke(pen) : dots_of(pen));
}

/// From the lower to the higher end at every point, where that is all there is.
void draw_envelope(const Paper& on, const Curve& curve) {
  const Eigen::Index n = std::min(curve.low.size(), curve.high.size());
  Eigen::VectorXd x(2 * n);
  Eigen::VectorXd y(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    x.segment<2>(2 * i).setConstant(curve.x[i]);
    y.segment<2>(2 * i) << curve.low[i], curve.high[i];
  }
  draw_line(on, x, y, curve.pen, true);
}

void draw_curve(const Paper& on, const Curve& curve) {
  if (curve.y.size() == 0) return draw_envelope(on, curve);
  const Pen band{curve.pen.colour, Pattern::Dotted, '.', true};
  draw_line(on, curve.x, curve.low, band, true);
  draw_line(on, curve.x, curve.high, band, true);
  draw_line(on, curve.x, curve.y, curve.pen, curve.joined);
}

/// A glyph and what stands beside it.
void draw_spot(const Paper& on,
               double x,
               double y,
               char32_t glyph,
               const Style& style,
               const std::string& label) {
  const auto px = on.to_x(x);
  const auto py = on.to_y(y);
  const Frame& f = on.frame;
  if (!px || !py || *px < f.left || *px > f.right) return;
  if (*py < f.top || *py > f.bottom) return;
  const char* colour = ink_of(style.colour);
  std::string text;
  append_utf8(text, glyph);
  on.canvas.text(*px,
                 *py + 3.0,
                 text,
                 {.anchor = "middle", .size = 10.0, .colour = colour});
  if (label.empty()) return;
  on.canvas.text(*px + 6.0, *py + 4.0, label, {.size = 11.0, .colour = colour});
}

/// Upright lines at what is marked.
void draw_markers(const Paper& on, const Plot& plot) {
  for (const Marker& marker : plot.markers) {
    const auto at = on.to_x(marker.x);
    const Frame& f = on.frame;
    if (!at || *at < f.left || *at > f.right) continue;
    on.canvas.line(*at, f.top, *at, f.bottom, {ink::grey, 0.8, "2 3"});
  }
}

/// An entry of the legend.
struct Entry {
  std::string label;
  Pen pen;
  bool joined = true;
  char32_t glyph = 0;  ///< of spots, in place of a line
};

/// A letter is about half as wide as it is high.
double width_of(const std::string& words) { return 6.7 * text_width(words); }

double width_of(const Entry& entry) { return 46.0 + width_of(entry.label); }

/// How many lines they take, of a picture so wide.
int legend_lines(const std::vector<Entry>& entries, double width) {
  int lines = entries.empty() ? 0 : 1;
  double x = 0.0;
  for (const Entry& entry : entries) {
    if (x > 0.0 && x + width_of(entry) > width) {
      ++lines;
      x = 0.0;
    }
    x += width_of(entry);
  }
  return lines;
}

void draw_legend(const Paper& on, const std::vector<Entry>& entries) {
  double x = on.frame.left;
  const double width = on.frame.right - on.frame.left;
  const int lines = legend_lines(entries, width);
  double y = on.frame.top - legend_height * lines + 7.0;
  for (const Entry& entry : entries) {
    if (x > on.frame.left && x + width_of(entry) > on.frame.right) {
      x = on.frame.left;
      y += legend_height;
    }
    if (entry.glyph != 0) {
      std::string text;
      append_utf8(text, entry.glyph);
      on.canvas.text(x + 12.0,
                     y + 4.5,
                     text,
                     {.anchor = "middle", .colour = ink_of(entry.pen.colour)});
    } else if (entry.joined) {
      on.canvas.line(x, y, x + 24.0, y, pen_stroke(entry.pen));
    } else {
      const Stroke dot = dots_of(entry.pen);
      on.canvas.circle(x + 12.0, y, dot.width / 2.0 + 1.0, dot.colour);
    }
    on.canvas.text(x + 30.0, y + 4.5, entry.label);
    x += width_of(entry);
  }
}

template <class Lines>
std::vector<Entry> legend_of(const Lines& lines) {
  std::vector<Entry> entries;
  for (const auto& line : lines) {
    if (line.label.empty()) continue;
    entries.push_back({line.label, line.pen, line.joined});
  }
  return entries;
}

/// Of curves, then of the spots that have a meaning.
std::vector<Entry> legend_of_plot(const Plot& plot) {
  std::vector<Entry> entries = legend_of(plot.curves);
  for (const auto& [glyph, meaning] : plot.meanings) {
    const auto spot = std::ranges::find(plot.spots, glyph, &Spot::glyph);
    if (spot == plot.spots.end()) continue;
    entries.push_back({meaning, {spot->style.colour}, false, glyph});
  }
  return entries;
}

Frame frame_of(const Picture& picture, const std::vector<Entry>& legend) {
  return {
      left_margin,
      top_margin + (picture.titled ? title_height : 0.0) +
          legend_height *
              legend_lines(legend, picture.width - right_margin - left_margin),
      picture.width - right_margin,
      picture.height - bottom_margin};
}

void draw_title(SvgCanvas& canvas,
                const Picture& picture,
                const std::string& title) {
  if (!picture.titled) return;
  canvas.text(left_margin, top_margin + 8.0, title, {.size = 14.0});
}

struct Extent {
  double low = 0.0;
  double high = 0.0;
  bool found = false;

  void take(const Eigen::VectorXd& values) {
    for (const double v : values) {
      if (!std::isfinite(v)) continue;
      low = found ? std::min(low, v) : v;
      high = found ? std::max(high, v) : v;
      found = true;
    }
  }
};

/// Around the first path, as many pixels to one unit across as up.
Ranges equal_ranges(const PlanePlot& plane, const Frame& f) {
  Extent x;
  Extent y;
  if (!plane.paths.empty()) {
    x.take(plane.paths.front().x);
    y.take(plane.paths.front().y);
  }
  const double across = f.right - f.left;
  const double up = f.bottom - f.top;
  const double unit =
      std::max({(x.high - x.low) / across, (y.high - y.low) / up, 1e-12});
  const auto axis = [](const std::string& title, double middle, double half) {
    return Axis{title, "", middle - half, middle + half, false};
  };
  return {axis(plane.x_label, 0.5 * (x.low + x.high), 0.56 * unit * across),
          axis(plane.y_label, 0.5 * (y.low + y.high), 0.56 * unit * up)};
}

}  // namespace

std::string svg_plot(const Plot& plot, const Picture& picture) {
  const std::vector<Entry> legend = legend_of_plot(plot);
  const Frame f = frame_of(picture, legend);
  const auto [x, y] = shown_ranges(plot);
  SvgCanvas canvas(picture.width, picture.height, plot.title);
  const Paper on{
      canvas, f, Scale(x, f.left, f.right), Scale(y, f.bottom, f.top)};
  draw_title(canvas, picture, plot.title);
  draw_axes(canvas, x, y, f);
  draw_markers(on, plot);
  for (const Curve& curve : plot.curves) draw_curve(on, curve);
  for (const Spot& spot : plot.spots) {
    draw_spot(on, spot.x, spot.y, spot.glyph, spot.style, "");
  }
  draw_legend(on, legend);
  return canvas.svg();
}

std::string svg_plane(const PlanePlot& plane, const Picture& picture) {
  const std::vector<Entry> legend = legend_of(plane.paths);
  const Frame f = frame_of(picture, legend);
  const auto [x, y] = equal_ranges(plane, f);
  SvgCanvas canvas(picture.width, picture.height, plane.title);
  const Paper on{
      canvas, f, Scale(x, f.left, f.right), Scale(y, f.bottom, f.top)};
  draw_title(canvas, picture, plane.title);
  if (!plane.x_label.empty()) draw_axes(canvas, x, y, f);
  for (const Path& path : plane.paths) {
    draw_line(on, path.x, path.y, path.pen, path.joined);
  }
  for (const PlaneSpot& spot : plane.spots) {
    draw_spot(on, spot.x, spot.y, spot.glyph, spot.style, spot.label);
  }
  draw_legend(on, legend);
  return canvas.svg();
}

}  // namespace tapfit::tui
