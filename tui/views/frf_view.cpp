#include "tui/views/frf_view.hpp"

#include "tui/layout.hpp"
#include "tui/number.hpp"
#include "tui/plot.hpp"
#include "tui/views/frf_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::tui {
namespace {

using Strip = FrfState::Strip;

Table frf_table(const signal::FrfSet& frfs) {
  Table table{{{"FRF"}, {"coh", true}, {"sd %", true}, {"hits", true}}, {}};
  for (const signal::Frf& frf : frfs.frfs) {
    const double coherence =
        frf.coherence.size() > 0 ? frf.coherence.mean() : std::nan("");
    // One number for the scatter: the median of sd / |H| over the lines.
    std::vector<double> scatter;
    for (Eigen::Index i = 0; i < std::min(frf.H.size(), frf.variance.size());
         ++i) {
      const double size = std::abs(frf.H[i]);
      if (size > 0.0) scatter.push_back(std::sqrt(frf.variance[i]) / size);
    }
    double median = std::nan("");
    if (!scatter.empty()) {
      const auto middle =
          scatter.begin() + static_cast<std::ptrdiff_t>(scatter.size() / 2);
      std::nth_element(scatter.begin(), middle, scatter.end());
      median = *middle;
    }
    table.rows.push_back({{signal::name(frf),
                           fixed(coherence, 3),
                           fixed(100.0 * median, 2),
                           std::to_string(frf.hits)},
                          {}});
  }
  return table;
}

void draw_strip(Screen& screen,
                const Rect& rect,
                const signal::FrfSet& frfs,
                const signal::Frf& frf,
                const FrfState& state) {
  Plot plot = frf_plot(frfs, state.range, false);
  const Eigen::VectorXd f = frfs.frequency_hz();
  if (state.strip == Strip::Phase) {
    plot.y = {"phase", "deg", -190.0, 190.0, false};
    plot.curves.push_back(phase_curve("", f, frf.H, {Colour::Purple}));
  } else {
    plot.y = {"coherence", "", -0.02, 1.05, false};
    if (frf.coherence.size() == f.size()) {
      plot.curves.push_back({"", f, frf.coherence, {}, {}, {Colour::Green}});
    }
  }
  draw_plot(screen, rect, plot);
}

std::string cursor_line(const signal::FrfSet& frfs,
                        const signal::Frf& frf,
                        const PlotRange& range) {
  const Eigen::VectorXd f = frfs.frequency_hz();
  if (f.size() == 0 || frf.H.size() != f.size()) return "no lines";
  if (!range.cursor_set) {
    return fmt::format("{} lines, {} to {} Hz, exponential window sigma {} 1/s",
                       f.size(),
                       number(f[0]),
                       number(f[f.size() - 1]),
                       number(frfs.s[0].real(), 3));
  }
  Eigen::Index at = 0;
  (f.array() - range.cursor).abs().minCoeff(&at);
  const double phase = std::arg(frf.H[at]) * 180.0 / std::numbers::pi;
  std::string text = fmt::format("{} Hz   |H| {} {}   ∠ {}°",
                                 fixed(f[at], 3),
                                 number(std::abs(frf.H[at])),
                                 accelerance_unit,
                                 fixed(phase, 1));
  if (frf.coherence.size() == f.size()) {
    text += fmt::format("   coherence {}", fixed(frf.coherence[at], 4));
  }
  if (frf.variance.size() == f.size()) {
    text += fmt::format("   sd {}",
                        number(std::sqrt(std::max(frf.variance[at], 0.0)), 2));
  }
  return text;
}

}  // namespace

Screen frf_view(const signal::FrfSet& frfs,
                const FrfState& state,
                const Canvas& canvas) {
  Screen screen(canvas);
  if (frfs.frfs.empty()) {
    screen.text(1, 1, "There is no FRF: no run has an accepted hit (1).");
    return screen;
  }
  const Table table = frf_table(frfs);
  const signal::Frf& frf = frfs.frfs[settled(table, state.list)];
  const int list_width = std::min(canvas.width * 3 / 8, 36);
  const auto [side, body] =
      split_left({0, 0, canvas.width, canvas.height - 1}, list_width);
  draw_table(screen, side, table, state.list, true);
  const int strip =
      state.strip == Strip::None ? 0 : std::clamp(body.height / 3, 6, 14);
  const auto [upper, rest] = split_top(body, body.height - strip);
  Plot plot = frf_plot(frfs, state.range, state.log);
  plot.title = signal::name(frf);
  plot.x_labels = strip == 0;
  plot.curves.push_back(
      measured_curve("measured", frfs.frequency_hz(), frf, state.band));
  draw_plot(screen, upper, plot);
  if (strip > 0)
    draw_strip(screen, split_top(rest, strip).first, frfs, frf, state);
  screen.text(1,
              canvas.height - 1,
              cursor_line(frfs, frf, state.range),
              {.colour = Colour::Yellow},
              canvas.width - 2);
  return screen;
}

Screen FrfPage::draw(const Snapshot& known, const Canvas& canvas) const {
  return frf_view(*known.frfs, state_, canvas);
}

bool FrfPage::press(const Snapshot& known, Key key, Command&) {
  const signal::FrfSet& frfs = *known.frfs;
  if (frfs.frfs.empty()) return false;
  if (key == U'x') {
    state_.log = !state_.log;
  } else if (key == U'b') {
    state_.band = !state_.band;
  } else if (key == keys::tab || key == U'c') {
    state_.strip = state_.strip == Strip::Phase       ? Strip::Coherence
                   : state_.strip == Strip::Coherence ? Strip::None
                                                      : Strip::Phase;
  } else if (!list_key(state_.list, frf_table(frfs), key)) {
    const FrequencySpan span = frequency_span(frfs);
    return range_key(state_.range, key, span.lo, span.hi, line_spacing(frfs));
  }
  return true;
}

std::vector<KeyHelp> FrfPage::keys() const {
  return {{"j k", "FRF"},
          {"h l", "cursor"},
          {"H L", "faster"},
          {"x", "log/linear"},
          {"Tab", "phase/coherence"},
          {"b", "band"},
          {"+ -", "zoom"},
          {"[ ]", "pan"},
          {"_", "whole band"},
          {"/", "filter"}};
}

std::string FrfPage::help() const {
  return "Accelerance of the selected point (response / reference) from all "
         "accepted hits of its run. The faint band is the 95 % confidence "
         "band from the scatter over hits. coh is the mean coherence, sd % "
         "the median relative deviation. The FRF carries the exponential "
         "window's damping (sigma), which is taken out of modes and allowed "
         "for in every comparison.";
}

}  // namespace tapfit::tui
