#include "tui/document/svg_plot.hpp"

#include "tui/widgets/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace tapfit::tui {
namespace {

constexpr double left_margin = 62.0;
constexpr double right_margin = 14.0;
constexpr double bottom_margin = 44.0;
constexpr double legend_height = 24.0;
constexpr double top_margin = 8.0;

/// One axis, from values to pixels.
class Scale {
 public:
  Scale(const SvgAxis& axis, double at_low, double at_high)
      : log_(axis.log),
        low_(shown(axis.low)),
        high_(shown(axis.high)),
        at_low_(at_low),
        at_high_(at_high) {}

  [[nodiscard]] std::optional<double> operator()(double value) const {
    if (!std::isfinite(value) || (log_ && value <= 0.0)) return std::nullopt;
    return at_low_ +
           (shown(value) - low_) / (high_ - low_) * (at_high_ - at_low_);
  }

 private:
  [[nodiscard]] double shown(double value) const {
    return log_ ? std::log10(value) : value;
  }
  bool log_;
  double low_, high_, at_low_, at_high_;
};

using Values = Eigen::VectorXd SvgCurve::*;

/// The axis with its range found where it has none.
SvgAxis with_range(SvgAxis axis, const SvgPlot& plot, Values values) {
  if (axis.low < axis.high && (!axis.log || axis.low > 0.0)) return axis;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const SvgCurve& curve : plot.curves) {
    for (const double value : curve.*values) {
      if (!std::isfinite(value) || (axis.log && value <= 0.0)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(low <= high)) {
    low = axis.log ? 0.1 : 0.0;
    high = 1.0;
  }
  // Six decades show what there is to see.
  if (axis.log) low = std::max(low, 1e-6 * high);
  const bool x_axis = values == &SvgCurve::x;
  if (low == high) {
    const double room = axis.log ? 0.0 : std::max(std::abs(high), 1.0) / 2.0;
    low = axis.log ? low / 2.0 : low - room;
    high = axis.log ? high * 2.0 : high + room;
  } else if (!x_axis) {
    const double room =
        axis.log ? std::pow(high / low, 0.04) : 0.04 * (high - low);
    low = axis.log ? low / room : low - room;
    high = axis.log ? high * room : high + room;
  }
  axis.low = low;
  axis.high = high;
  return axis;
}

struct Frame {
  double left, top, right, bottom;
};

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
               const SvgAxis& x,
               const SvgAxis& y,
               const Frame& f) {
  const Stroke grid{ink::pale, 0.7};
  const Scale to_x(x, f.left, f.right);
  const Scale to_y(y, f.bottom, f.top);
  for (const Tick& tick : ticks(x.low, x.high, x.log, 8)) {
    const auto at = to_x(tick.value);
    if (!at) continue;
    canvas.line(*at, f.top, *at, f.bottom, grid);
    canvas.text(*at,
                f.bottom + 16.0,
                tick_label(tick.label),
                {.anchor = "middle", .size = 12.0});
  }
  for (const Tick& tick : ticks(y.low, y.high, y.log, 6)) {
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
  canvas.text(
      (f.left + f.right) / 2.0, f.bottom + 36.0, x.title, {.anchor = "middle"});
  canvas.text(14.0,
              (f.top + f.bottom) / 2.0,
              y.title,
              {.anchor = "middle", .turn_deg = -90.0});
}

using Point = std::pair<double, double>;

/// Appends a run of points, of each pixel column the lowest and the highest.
void append_run(std::string& d, const std::vector<Point>& run, double column) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < run.size();) {
    std::size_t low = i;
    std::size_t high = i;
    std::size_t end = i;
    const double cell = std::floor(run[i].first / column);
    while (end < run.size() && std::floor(run[end].first / column) == cell) {
      if (run[end].second < run[low].second) low = end;
      if (run[end].second > run[high].second) high = end;
      ++end;
    }
    kept.push_back(run[std::min(low, high)]);
    if (low != high) kept.push_back(run[std::max(low, high)]);
    if (end == run.size() && std::max(low, high) != end - 1) {
      kept.push_back(run[end - 1]);
    }
    i = end;
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    d += (i == 0   ? "M"
          : i == 1 ? "L"
                   : " ") +
         coordinate(kept[i].first) + " " + coordinate(kept[i].second);
  }
}

std::string curve_path(const SvgCurve& curve,
                       const Scale& to_x,
                       const Scale& to_y,
                       const Frame& f) {
  std::string d;
  std::vector<Point> run;
  const auto flush = [&] {
    if (!run.empty()) append_run(d, run, 1.0);
    run.clear();
  };
  for (Eigen::Index k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k) {
    const auto x = to_x(curve.x(k));
    const auto y = to_y(curve.y(k));
    const bool drawn = x && y && *x >= f.left - 0.5 && *x <= f.right + 0.5 &&
                       (!curve.dots || (*y >= f.top && *y <= f.bottom));
    if (!drawn) {
      flush();
    } else if (curve.dots) {
      d += fmt::format("M{} {}h0", coordinate(*x), coordinate(*y));
    } else {
      run.emplace_back(*x, std::clamp(*y, f.top, f.bottom));
    }
  }
  flush();
  return d;
}

/// A letter is about half as wide as it is high.
double width_of(const std::string& words) {
  const auto letters = std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  return 6.7 * static_cast<double>(letters);
}

void draw_legend(SvgCanvas& canvas, const SvgPlot& plot, const Frame& f) {
  double x = f.left;
  for (const SvgCurve& curve : plot.curves) {
    if (curve.label.empty()) continue;
    const double y = top_margin + 7.0;
    if (curve.dots) {
      canvas.circle(
          x + 12.0, y, curve.stroke.width / 2.0 + 1.0, curve.stroke.colour);
    } else {
      canvas.line(x, y, x + 24.0, y, curve.stroke);
    }
    canvas.text(x + 30.0, y + 4.5, curve.label);
    x += 46.0 + width_of(curve.label);
  }
}

}  // namespace

std::string svg_plot(const SvgPlot& plot) {
  const bool legend = std::any_of(
      plot.curves.begin(), plot.curves.end(), [](const SvgCurve& curve) {
        return !curve.label.empty();
      });
  const Frame f{left_margin,
                top_margin + (legend ? legend_height : 0.0),
                plot.width - right_margin,
                plot.height - bottom_margin};
  const SvgAxis x = with_range(plot.x, plot, &SvgCurve::x);
  const SvgAxis y = with_range(plot.y, plot, &SvgCurve::y);
  const Scale to_x(x, f.left, f.right);
  const Scale to_y(y, f.bottom, f.top);
  SvgCanvas canvas(plot.width, plot.height, plot.name);
  draw_axes(canvas, x, y, f);
  for (const double value : plot.upright) {
    const auto at = to_x(value);
    if (!at || *at < f.left || *at > f.right) continue;
    canvas.line(*at, f.top, *at, f.bottom, {ink::grey, 0.8, "2 3"});
  }
  for (const SvgCurve& curve : plot.curves) {
    Stroke stroke = curve.stroke;
    stroke.round_ends = stroke.round_ends || curve.dots;
    const std::string d = curve_path(curve, to_x, to_y, f);
    if (!d.empty()) canvas.path(d, stroke);
  }
  if (legend) draw_legend(canvas, plot, f);
  return canvas.svg();
}

}  // namespace tapfit::tui
