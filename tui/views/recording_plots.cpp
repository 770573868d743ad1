#include "tui/views/recording_plots.hpp"

#include "signal/frf_set/measured_coherence.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace tapfit::tui {
namespace {

using acquisition::Hit;

std::string unit_of(acquisition::Quantity quantity) {
  switch (quantity) {
    case acquisition::Quantity::Force:
      return "N";
    case acquisition::Quantity::Acceleration:
      return "m/s²";
    case acquisition::Quantity::Velocity:
      return "m/s";
    case acquisition::Quantity::Displacement:
      return "m";
  }
  return "";
}

/// What has been measured by then.
void cut_off(Curve& curve, double time_s) {
  Eigen::Index n = 0;
  while (n < curve.x.size() && curve.x[n] <= time_s) ++n;
  for (Eigen::VectorXd* values : {&curve.x, &curve.y, &curve.low, &curve.high})
    if (values->size() >= n) values->conservativeResize(n);
}

/// Rows of the trace on show, and one more at each end.
struct TraceRows {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

TraceRows rows_on_show(const Trace& trace, const PlotRange& shown) {
  const double rate = trace.sample_rate_hz / static_cast<double>(trace.stretch);
  const auto first =
      std::max<Eigen::Index>(static_cast<Eigen::Index>(shown.lo * rate) - 1, 0);
  const auto last = std::min<Eigen::Index>(
      static_cast<Eigen::Index>(shown.hi * rate) + 2, trace.low.rows());
  return {first, std::max<Eigen::Index>(last - first, 0)};
}

/// Every sample on show, joined; of a thinned record the lowest and highest of
/// each stretch at its middle.
Curve record_curve(const Trace& trace,
                   Eigen::Index channel,
                   const PlotRange& shown) {
  const auto [first, n] = rows_on_show(trace, shown);
  Curve curve{"", {}, {}, {}, {}, {Colour::Sky}};
  const auto stretch = static_cast<double>(trace.stretch);
  curve.x =
      (Eigen::VectorXd::LinSpaced(
           n, static_cast<double>(first), static_cast<double>(first + n - 1))
               .array() *
           stretch +
       0.5 * (stretch - 1.0)) /
      trace.sample_rate_hz;
  const Eigen::VectorXd low =
      trace.low.col(channel).segment(first, n).cast<double>();
  if (trace.stretch == 1) {
    curve.y = low;
  } else {
    curve.low = low;
    curve.high = trace.high.col(channel).segment(first, n).cast<double>();
  }
  return curve;
}

/// Of a plot, a sample in each; two lines of an envelope go into one.
int sample_columns(const Screen& screen, int cells) {
  const CellPixels cell = screen.pixels();
  return cell.none() ? cells : cells * cell.width / 2;
}

/// Whether each sample on show has a column of its own.
bool fits_samples(const Trace& trace, const PlotRange& shown, int columns) {
  const Eigen::Index n = rows_on_show(trace, shown).count;
  return trace.stretch == 1 && n >= 2 && n <= columns;
}

/// @param columns none: whatever is known goes to a file
Plot channel_plot(const RecordingInput& input,
                  const RecordingState& state,
                  std::size_t channel,
                  std::optional<int> columns) {
  const Trace& trace = input.traces[state.run];
  const PlotRange shown = resolved(state.range, 0.0, trace.duration_s());
  Plot plot;
  plot.x = {"t", "s", shown.lo, shown.hi, false};
  if (shown.cursor_set) plot.cursor = shown.cursor;
  if (channel < input.bundle.channels.size()) {
    const acquisition::Channel& c = input.bundle.channels[channel];
    plot.y = {c.name, unit_of(c.quantity), 0.0, 0.0, false};
  }
  const auto column = static_cast<Eigen::Index>(channel);
  const Envelope e = envelope(
      trace, column, shown.lo, shown.hi, 2 * std::max(columns.value_or(1), 1));
  Curve curve{"", e.time_s, {}, e.low, e.high, {Colour::Sky}};
  if (e.time_s.size() > 0) {
    // The scale stays while samples come in.
    const double low = std::min(e.low.minCoeff(), 0.0);
    const double high = std::max(e.high.maxCoeff(), 0.0);
    const double room = 0.05 * (high - low);
    plot.y.lo = low - room;
    plot.y.hi = high + room;
  }
  if (column < trace.low.cols() &&
      (!columns || fits_samples(trace, shown, *columns))) {
    curve = record_curve(trace, column, shown);
  }
  if (state.playing.on) {
    cut_off(curve, state.playing.time_s);
    plot.cursor = state.playing.time_s;
  }
  plot.curves.push_back(std::move(curve));
  return plot;
}

/// Time and value under the cursor; of a thinned record the lowest and highest
/// of the samples that lie there.
std::string under_cursor(const Trace& trace,
                         std::size_t channel,
                         const Plot& plot) {
  const auto column = static_cast<Eigen::Index>(channel);
  if (!plot.cursor || trace.low.rows() == 0 || column >= trace.low.cols()) {
    return {};
  }
  const double sample = std::round(*plot.cursor * trace.sample_rate_hz);
  const Eigen::Index row = std::clamp<Eigen::Index>(
      static_cast<Eigen::Index>(sample) / trace.stretch,
      0,
      trace.low.rows() - 1);
  const double low = trace.low(row, column);
  const double high = trace.high(row, column);
  const std::string value =
      low == high ? number(low, 4)
                  : fmt::format("{} to {}", number(low, 4), number(high, 4));
  return fmt::format("{} s: {} {}",
                     number(sample / trace.sample_rate_hz, 6),
                     value,
                     plot.y.unit);
}

void mark_hits(Plot& plot,
               const RecordingInput& input,
               const RecordingState& state,
               std::size_t selected) {
  const std::vector<Hit>& hits = input.hits.runs[state.run];
  std::size_t known = hits.size();
  if (state.playing.on) {
    known = hits_by(input, state.run, state.playing.time_s);
  }
  for (std::size_t i = 0; i < known; ++i) {
    const Hit& hit = hits[i];
    Style style{.colour = hit.accepted ? Colour::Green : Colour::Red};
    style.reverse = i == selected;
    plot.markers.push_back({hit.time_s, hit.accepted ? U'▼' : U'✗', style});
  }
  if (selected >= known || !(input.hits.sample_rate_hz > 0.0)) return;
  if (state.zoom != 0) return;  // the block is all there is to see
  const double rate = input.hits.sample_rate_hz;
  const double begin = static_cast<double>(hits[selected].begin) / rate;
  const double block = static_cast<double>(input.hits.block) / rate;
  plot.shades.push_back({begin, begin + block, {.colour = Colour::Grey}});
}

const HitWindow* window_of(const RecordingInput& input, std::size_t hit) {
  if (input.look == nullptr || hit >= input.look->windows.size())
    return nullptr;
  const std::optional<HitWindow>& window = input.look->windows[hit];
  return window ? &*window : nullptr;
}

constexpr Pen window_pen{Colour::Orange, Pattern::Dashed, 'o'};

/// The force window, as high as the plot.
void add_force_window(Plot& plot, const HitWindow& window) {
  const Eigen::Index n = window.pulse.size();
  Curve curve{"force window", {}, {}, {}, {}, window_pen};
  curve.x.resize(n + 4);
  curve.y = Eigen::VectorXd::Zero(n + 4);
  const double end = window.pulse_s + window.step_s * static_cast<double>(n);
  curve.x[0] = window.begin_s;
  curve.x[1] = window.pulse_s - window.step_s;
  for (Eigen::Index i = 0; i < n; ++i) {
    curve.x[i + 2] = window.pulse_s + window.step_s * static_cast<double>(i);
    curve.y[i + 2] = window.pulse[i];
  }
  curve.x[n + 2] = end;
  curve.x[n + 3] = window.end_s;
  curve.y *= plot.y.hi / 1.05;
  plot.curves.push_back(std::move(curve));
}

/// What the response is multiplied with: as high as the plot at the trigger.
void add_exponential_window(Plot& plot, const HitWindow& window) {
  constexpr Eigen::Index points = 200;
  Curve curve{"exponential window", {}, {}, {}, {}, window_pen};
  curve.x = Eigen::VectorXd::LinSpaced(
      points, std::max(window.begin_s, window.trigger_s), window.end_s);
  curve.y.resize(points);
  for (Eigen::Index i = 0; i < points; ++i) {
    curve.y[i] = plot.y.hi / 1.05 * window.exponential(curve.x[i]);
  }
  plot.curves.push_back(std::move(curve));
}

}  // namespace

void draw_channels(Screen& screen,
                   const Rect& rect,
                   const RecordingInput& input,
                   const RecordingState& state,
                   std::size_t selected) {
  const acquisition::Run& run = input.bundle.runs[state.run];
  constexpr int least = 8;
  const int sensors = static_cast<int>(run.sensors.size());
  const int panes = 1 + std::clamp(rect.height / least - 1, 1, sensors);
  const HitWindow* window =
      state.zoom != 0 ? window_of(input, selected) : nullptr;
  Rect left = rect;
  for (int pane = 0; pane < panes && !left.empty(); ++pane) {
    const bool last = pane + 1 == panes;
    const int rows = last ? left.height : (rect.height - 2) / panes;
    const auto [here, below] = split_top(left, rows);
    left = below;
    const std::size_t sensor =
        sensors == 0 ? 0
                     : (state.sensor + static_cast<std::size_t>(pane - 1)) %
                           run.sensors.size();
    if (pane > 0 && sensors == 0) break;
    const acquisition::Placement& at =
        pane == 0 ? run.hammer : run.sensors[sensor];
    const std::optional<int> columns =
        screen.drawings() == nullptr
            ? std::optional(sample_columns(screen, here.width))
            : std::nullopt;
    Plot plot = channel_plot(input, state, at.channel, columns);
    plot.x_labels = last;
    const std::string title =
        pane == 0
            ? "hammer " + name(at.dof)
            : fmt::format("{} ({} of {})", name(at.dof), sensor + 1, sensors);
    plot.title = title;
    const std::string value =
        under_cursor(input.traces[state.run], at.channel, plot);
    if (!value.empty()) {
      // What a window's curve is has room behind it, if there is any.
      const int room =
          here.width - text_width(plot.y.label + " []  " + plot.y.unit);
      const int legend = window == nullptr ? 0 : pane == 0 ? 16 : 22;
      const std::string brief = name(at.dof) + "  " + value;
      plot.title = fitting({title + "  " + value, brief}, room - legend);
      if (text_width(plot.title) > room) plot.title = value;
    }
    mark_hits(plot, input, state, selected);
    if (window != nullptr && pane == 0) add_force_window(plot, *window);
    if (window != nullptr && pane > 0) add_exponential_window(plot, *window);
    draw_plot(screen, here, plot);
  }
}

void draw_average(Screen& screen,
                  const Rect& rect,
                  const RecordingInput& input,
                  const RecordingState& state) {
  if (input.look == nullptr) {
    screen.text(rect.x + 1, rect.y, "average …", {.colour = Colour::Grey});
    return;
  }
  const std::vector<Hit>& hits = input.hits.runs[state.run];
  std::size_t count = input.look->averages.size();
  if (state.playing.on) {
    const auto end =
        hits.begin() + static_cast<std::ptrdiff_t>(
                           hits_by(input, state.run, state.playing.time_s));
    count = std::min<std::size_t>(
        count,
        static_cast<std::size_t>(std::count_if(
            hits.begin(), end, [](const Hit& h) { return h.accepted; })));
  }
  if (count == 0) {
    screen.text(rect.x + 1,
                rect.y,
                state.playing.on ? "average: no hit yet"
                                 : "average: no hit is accepted",
                {.colour = Colour::Grey},
                rect.width - 1);
    return;
  }
  const auto curve_after = [&](std::size_t n, const Pen& pen, bool band) {
    const std::vector<signal::Frf>& frfs = input.look->averages[n - 1];
    const signal::Frf& frf = frfs[state.sensor % frfs.size()];
    const Eigen::VectorXd f = input.look->s.imag() / (2.0 * std::numbers::pi);
    Curve curve = measured_curve("", f, frf, band);
    curve.pen = pen;
    return curve;
  };
  Plot plot;
  const signal::Frf& frf =
      input.look->averages[count - 1][state.sensor %
                                      input.look->averages[count - 1].size()];
  plot.x = {"f", "Hz", 0.0, 0.0, false};
  plot.y = {"|H|", accelerance_unit, 0.0, 0.0, true};
  std::string agreement =
      fmt::format("{} hit{}", frf.hits, frf.hits == 1 ? "" : "s");
  if (signal::has_coherence(frf)) {
    agreement += ", coh " + fixed(frf.coherence.mean(), 4);
  }
  const std::string unit = fmt::format("{} [{}]  ", plot.y.label, plot.y.unit);
  plot.title = fitting({signal::name(frf) + ": " + agreement, agreement},
                       rect.width - text_width(unit));
  plot.curves.push_back(curve_after(count, {Colour::Sky}, frf.hits > 1));
  draw_plot(screen, rect, plot);
}

}  // namespace tapfit::tui
