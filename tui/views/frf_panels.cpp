#include "tui/views/frf_panels.hpp"

#include "modal/fit/frf_peaks.hpp"
#include "signal/checks/confidence_band.hpp"
#include "signal/frf_set/measured_coherence.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/plane_plot.hpp"
#include "tui/widgets/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::tui {
namespace {

using Eigen::Index;
using signal::Frf;
using signal::FrfSet;
using Panel = FrfState::Panel;

/// Of the selected one, then of those laid over it.
Pen curve_pen(std::size_t place) {
  static constexpr std::array<Pen, 6> pens{{
      {Colour::Sky, Pattern::Solid, '*'},
      {Colour::Orange, Pattern::Dashed, 'o'},
      {Colour::Green, Pattern::Dotted, '+'},
      {Colour::Purple, Pattern::Dashed, 'x'},
      {Colour::Yellow, Pattern::Dotted, '%'},
      {Colour::Red, Pattern::Dashed, '@'},
  }};
  return pens[place % pens.size()];
}

Plot empty_plot(const FrfChoice& choice, const FrfState& state) {
  Plot plot = frf_plot(choice.frfs, state.range, choice.form);
  plot.x.log = state.log_f && plot.x.lo > 0.0;
  if (state.mark) {
    const double other = plot.cursor.value_or(*state.mark);
    plot.shades.push_back({std::min(*state.mark, other),
                           std::max(*state.mark, other),
                           {.colour = Colour::Grey}});
  }
  return plot;
}

Plot magnitude_plot(const FrfChoice& choice, const FrfState& state) {
  Plot plot = empty_plot(choice, state);
  const Eigen::VectorXd f = choice.frfs.frequency_hz();
  for (std::size_t i = 0; i < choice.frfs.frfs.size(); ++i) {
    const Frf& frf = choice.frfs.frfs[i];
    Curve curve =
        measured_curve(signal::name(frf), f, frf, state.band && i == 0);
    curve.pen = curve_pen(i);
    plot.curves.push_back(std::move(curve));
  }
  return in_scale(std::move(plot), state.scale);
}

Plot strip_plot(const FrfChoice& choice, const FrfState& state) {
  Plot plot = empty_plot(choice, state);
  const bool phase = state.panel == Panel::Phase;
  plot.y = phase ? Axis{"phase", "deg", -190.0, 190.0, false}
                 : Axis{"coherence", "", -0.02, 1.05, false};
  const Eigen::VectorXd f = choice.frfs.frequency_hz();
  for (std::size_t i = 0; i < choice.frfs.frfs.size(); ++i) {
    const Frf& frf = choice.frfs.frfs[i];
    if (phase) {
      plot.curves.push_back(phase_curve("", f, frf.H, curve_pen(i)));
    } else if (signal::has_coherence(frf)) {
      plot.curves.push_back({"", f, frf.coherence, {}, {}, curve_pen(i)});
    }
  }
  return plot;
}

/// Real (or imaginary) parts.
Plot part_plot(const FrfChoice& choice, const FrfState& state, bool real) {
  Plot plot = empty_plot(choice, state);
  plot.y.label = real ? "Re H" : "Im H";
  const Eigen::VectorXd f = choice.frfs.frequency_hz();
  for (std::size_t i = 0; i < choice.frfs.frfs.size(); ++i) {
    const Frf& frf = choice.frfs.frfs[i];
    if (frf.H.size() != f.size()) continue;
    Curve curve{real ? signal::name(frf) : "", f, {}, {}, {}, curve_pen(i)};
    curve.y =
        real ? Eigen::VectorXd(frf.H.real()) : Eigen::VectorXd(frf.H.imag());
    if (i == 0 && state.band && frf.variance.size() == f.size()) {
      const Eigen::VectorXd reach = signal::confidence_reach(frf);
      curve.low = curve.y - reach;
      curve.high = curve.y + reach;
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Path circle(const modal::PeakFit& fit) {
  constexpr Index points = 120;
  Path path{"", {}, {}, {Colour::Orange, Pattern::Dotted, '.'}, true};
  const Eigen::ArrayXd angle =
      Eigen::ArrayXd::LinSpaced(points, 0.0, 2.0 * std::numbers::pi);
  path.x = fit.centre.real() + fit.radius * angle.cos();
  path.y = fit.centre.imag() + fit.radius * angle.sin();
  return path;
}

/// Lines to draw: those zoomed to, else the peak's surroundings.
std::pair<Index, Index> nyquist_lines(const FrfSet& frfs,
                                      const std::optional<modal::PeakFit>& fit,
                                      const PlotRange& range) {
  const Index last = frfs.lines() - 1;
  const FrequencySpan span = frequency_span(frfs);
  const bool zoomed =
      !range.whole() && range.hi - range.lo < 0.999 * (span.hi - span.lo);
  if (!zoomed && fit) {
    const Index width = fit->last - fit->first + 1;
    return {std::max<Index>(fit->first - width, 0),
            std::min(fit->last + width, last)};
  }
  if (!zoomed) return {0, last};
  const Eigen::VectorXd f = frfs.frequency_hz();
  const auto at = [&](double hz) {
    return std::lower_bound(f.data(), f.data() + f.size(), hz) - f.data();
  };
  return {at(range.lo), std::clamp<Index>(at(range.hi), 0, last)};
}

std::string circle_words(const modal::PeakFit& fit,
                         signal::FrfForm form,
                         int width) {
  const std::string hz = number(fit.frequency_hz(), 6);
  const std::string damping = number(100.0 * fit.damping_ratio(), 4);
  const std::string size =
      fmt::format("{} {}", number(2.0 * fit.radius), unit_of(form));
  return fitting(
      {fmt::format("{} Hz, damping {} %, diameter {}", hz, damping, size),
       fmt::format("{} Hz, {} %, diam. {}", hz, damping, size)},
      width);
}

void draw_nyquist(Screen& screen,
                  const Rect& rect,
                  const FrfChoice& choice,
                  const FrfState& state) {
  const FrfSet& frfs = choice.frfs;
  const Frf& frf = choice.selected();
  const Index peak = chosen_peak(frfs, frf, state.range);
  const std::optional<modal::PeakFit> fit =
      modal::fit_peak(frfs.s, frf.H, peak);
  const auto [first, last] = nyquist_lines(frfs, fit, state.range);
  if (last <= first) return;
  PlanePlot plot;
  plot.title = signal::name(frf);
  plot.x_label = fmt::format("Re H [{}]", unit_of(choice.form));
  plot.y_label = fmt::format("Im H [{}]", unit_of(choice.form));
  for (std::size_t i = 0; i < choice.frfs.frfs.size(); ++i) {
    const Eigen::VectorXcd part =
        frfs.frfs[i].H.segment(first, last - first + 1);
    plot.paths.push_back({"", part.real(), part.imag(), curve_pen(i), true});
  }
  if (fit) {
    plot.paths.push_back(circle(*fit));
    const std::complex<double> top =
        fit->rest + fit->residue / (frfs.s[peak].real() - fit->pole.real());
    plot.spots.push_back({top.real(),
                          top.imag(),
                          U'●',
                          {.colour = Colour::Orange, .bold = true},
                          number(fit->frequency_hz(), 5) + " Hz"});
  }
  const Eigen::VectorXd f = frfs.frequency_hz();
  if (state.range.cursor_set) {
    Index at = 0;
    (f.array() - state.range.cursor).abs().minCoeff(&at);
    plot.spots.push_back(
        {frf.H[at].real(), frf.H[at].imag(), U'◆', {.colour = Colour::Yellow}});
  }
  const auto [body, lines] = split_top(rect, rect.height - 2);
  draw_plane(screen, body, plot);
  screen.text(lines.x + 1,
              lines.y,
              fmt::format("circle fit, {} to {} Hz{}",
                          number(f[first], 5),
                          number(f[last], 5),
                          fit ? ", residual " + percent(fit->deviation) : ""),
              {.colour = Colour::Grey},
              lines.width - 1);
  screen.text(lines.x + 1,
              lines.y + 1,
              fit ? circle_words(*fit, choice.form, lines.width - 1)
                  : "no circle: no resonance at the cursor",
              {},
              lines.width - 1);
}

}  // namespace

FrfChoice chosen_frfs(const FrfSet& frfs,
                      const std::vector<std::size_t>& shown,
                      signal::FrfForm form) {
  constexpr auto measured = signal::FrfForm::Accelerance;
  FrfChoice choice;
  choice.form = form;
  // An accelerance says nothing of the others at s = 0.
  const bool cut =
      form != measured && frfs.lines() > 0 && std::abs(frfs.s[0]) == 0.0;
  choice.frfs.s = frfs.s.tail(frfs.lines() - (cut ? 1 : 0));
  const Index lines = choice.frfs.lines();
  const Eigen::VectorXcd factor = signal::convert(
      Eigen::VectorXcd::Ones(lines), choice.frfs.s, measured, form);
  for (const std::size_t k : shown) {
    Frf frf = frfs.frfs[k];
    if (frf.H.size() == frfs.lines()) {
      frf.H = frf.H.tail(lines).cwiseProduct(factor).eval();
    }
    if (frf.variance.size() == frfs.lines()) {
      frf.variance =
          frf.variance.tail(lines).cwiseProduct(factor.cwiseAbs2()).eval();
    }
    if (frf.coherence.size() == frfs.lines()) {
      frf.coherence = frf.coherence.tail(lines).eval();
    }
    choice.frfs.frfs.push_back(std::move(frf));
  }
  return choice;
}

Index chosen_peak(const FrfSet& frfs, const Frf& frf, const PlotRange& range) {
  const Eigen::VectorXd size = frf.H.cwiseAbs();
  const Eigen::VectorXd f = frfs.frequency_hz();
  const FrequencySpan span = frequency_span(frfs);
  const PlotRange shown = resolved(range, span.lo, span.hi);
  Index chosen = -1;
  for (const Index line : modal::peak_lines(frf)) {
    if (f[line] < shown.lo || f[line] > shown.hi) continue;
    const bool nearer = chosen >= 0 && std::abs(f[line] - range.cursor) <
                                           std::abs(f[chosen] - range.cursor);
    const bool larger = chosen >= 0 && size[line] > size[chosen];
    if (chosen < 0 || (range.cursor_set ? nearer : larger)) chosen = line;
  }
  return chosen;
}

void draw_panel(Screen& screen,
                const Rect& rect,
                const FrfChoice& choice,
                const FrfState& state) {
  if (choice.frfs.lines() < 2) return;
  if (state.panel == Panel::Nyquist) {
    return draw_nyquist(screen, rect, choice, state);
  }
  if (state.panel == Panel::Magnitude) {
    return draw_plot(screen, rect, magnitude_plot(choice, state));
  }
  const bool parts = state.panel == Panel::Parts;
  const int below =
      parts ? rect.height / 2 : std::clamp(rect.height / 3, 6, 14);
  const auto [upper, lower] = split_top(rect, rect.height - below);
  Plot first =
      parts ? part_plot(choice, state, true) : magnitude_plot(choice, state);
  first.x_labels = false;
  draw_plot(screen, upper, first);
  draw_plot(
      screen,
      lower,
      parts ? part_plot(choice, state, false) : strip_plot(choice, state));
}

}  // namespace tapfit::tui
