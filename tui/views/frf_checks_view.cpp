#include "tui/views/frf_checks_view.hpp"

#include "modal/fit/frf_peaks.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::tui {
namespace {

using signal::DrivingPoint;
using signal::Frf;
using signal::FrfChecks;
using signal::FrfSet;
using signal::Reciprocal;

void draw_driving(Screen& screen,
                  const Rect& rect,
                  const FrfSet& frfs,
                  const DrivingPoint& point,
                  const PlotRange& range) {
  const Frf& frf = frfs.frfs[point.frf];
  const Eigen::VectorXd f = frfs.frequency_hz();
  Plot plot = frf_plot(frfs, range);
  plot.y.label = "Im H";
  plot.title = signal::name(frf) + ": every peak must point upwards";
  plot.curves.push_back({"", f, frf.H.imag(), {}, {}, {Colour::Sky}});
  plot.curves.push_back({"",
                         f,
                         Eigen::VectorXd::Zero(f.size()),
                         {},
                         {},
                         {Colour::Grey, Pattern::Dotted, '.', true}});
  for (const Eigen::Index line : modal::peak_lines(frf)) {
    const bool fair = frf.H[line].imag() > 0.0;
    plot.markers.push_back(
        {f[line],
         fair ? U'▼' : U'✗',
         {.colour = fair ? Colour::Green : Colour::Red, .bold = !fair}});
  }
  draw_plot(screen, rect, plot);
}

void draw_pair(Screen& screen,
               const Rect& rect,
               const FrfSet& frfs,
               const Reciprocal& pair,
               const PlotRange& range) {
  const Eigen::VectorXd f = frfs.frequency_hz();
  const auto [upper, lower] = split_top(rect, rect.height * 2 / 3);
  Plot size = frf_plot(frfs, range);
  Plot phase = frf_plot(frfs, range);
  size.x_labels = false;
  phase.y = {"phase", "deg", -190.0, 190.0, false};
  const Pen pens[]{{Colour::Sky}, {Colour::Orange, Pattern::Dashed, 'o'}};
  const std::size_t both[]{pair.frf, pair.other};
  for (std::size_t i = 0; i < 2; ++i) {
    const Frf& frf = frfs.frfs[both[i]];
    size.curves.push_back(
        magnitude_curve(signal::name(frf), f, frf.H, pens[i]));
    phase.curves.push_back(phase_curve("", f, frf.H, pens[i]));
  }
  draw_plot(
      screen, upper, in_scale(std::move(size), MagnitudeScale::Logarithmic));
  draw_plot(screen, lower, phase);
}

}  // namespace

std::string low_line(const DrivingPoint& point) {
  if (point.low == signal::LowLine::Mass) {
    return fmt::format("mass of {:.4g} kg", point.mass_kg);
  }
  if (point.low == signal::LowLine::Stiffness) {
    return fmt::format("stiffness of {:.4g} N/m", point.stiffness_n_per_m);
  }
  return "-";
}

std::string verdict(const DrivingPoint& point) {
  if (point.turned()) return "polarity inverted";
  if (point.wrong_peaks > 0) return "another point?";
  return point.active() ? "not passive" : "OK";
}

Table check_table(const FrfSet& frfs, const FrfChecks& checks) {
  Table table{{{"FRF"}, {"checked against"}, {"result"}, {"finding"}}, {}};
  for (const DrivingPoint& p : checks.driving) {
    const bool fair = verdict(p) == "OK";
    table.rows.push_back(
        {{signal::name(frfs.frfs[p.frf]),
          "driving point",
          verdict(p),
          fmt::format("{} of {} peaks inverted", p.wrong_peaks, p.peaks)},
         {.colour = fair ? Colour::Default : Colour::Red}});
  }
  for (const Reciprocal& p : checks.both_ways) {
    const bool fair = p.fair();
    table.rows.push_back({{signal::name(frfs.frfs[p.frf]),
                           signal::name(frfs.frfs[p.other]),
                           fair ? "match" : "differ",
                           fmt::format("difference {}", percent(p.difference))},
                          {.colour = fair ? Colour::Default : Colour::Orange}});
  }
  return table;
}

std::string finding(const DrivingPoint& p) {
  std::string words = fmt::format(
      "A driving point absorbs energy: {} of {} peaks of Im H positive, "
      "negative on {} of the lines (up to 5 % is acceptable)",
      p.peaks - p.wrong_peaks,
      p.peaks,
      percent(p.active_share));
  if (p.low != signal::LowLine::Neither) {
    words += "; the lowest lines are those of a " + low_line(p);
  }
  return words + ".";
}

std::string finding(const Reciprocal& p) {
  std::string words = fmt::format(
      "Hit and sensor exchanged, the FRF should stay: they differ by {}, best "
      "with a gain of {}",
      percent(p.difference),
      fixed(p.gain, 4));
  if (p.chi2 > 0.0) {
    words += fmt::format(
        ", which is {} times what the scatter over hits lets expect (chi²)",
        number(p.chi2, 3));
  }
  return words + ".";
}

std::optional<std::size_t> checked_frf(const FrfChecks& checks,
                                       std::size_t row) {
  const std::size_t driving = checks.driving.size();
  if (row < driving) return checks.driving[row].frf;
  if (row - driving < checks.both_ways.size()) {
    return checks.both_ways[row - driving].frf;
  }
  return std::nullopt;
}

void draw_checks(Screen& screen,
                 const Rect& rect,
                 const FrfSet& frfs,
                 const FrfChecks& checks,
                 const ListState& list,
                 const PlotRange& range) {
  const Table table = check_table(frfs, checks);
  if (table.rows.empty()) {
    screen.text(rect.x + 1,
                rect.y + 1,
                "No driving point was measured, and no pair both ways: hit "
                "where a sensor sits.",
                {},
                rect.width - 2);
    return;
  }
  const int rows = std::clamp(
      static_cast<int>(table.rows.size()) + 1, 3, std::max(rect.height / 3, 3));
  const auto [upper, rest] = split_top(rect, rows);
  draw_table(screen, upper, table, list, true);
  const std::size_t at = settled(table, list);
  const std::size_t driving = checks.driving.size();
  int y = rest.y;
  for (const std::string& line :
       wrapped(at < driving ? finding(checks.driving[at])
                            : finding(checks.both_ways[at - driving]),
               rect.width - 2,
               3)) {
    screen.text(rect.x + 1, y++, line, {.colour = Colour::Grey});
  }
  const Rect lower = split_top(rest, y - rest.y).second;
  if (at < driving) {
    draw_driving(screen, lower, frfs, checks.driving[at], range);
  } else {
    draw_pair(screen, lower, frfs, checks.both_ways[at - driving], range);
  }
}

std::optional<std::size_t> other_way(const FrfSet& frfs, std::size_t frf) {
  const Frf& wanted = frfs.frfs.at(frf);
  for (std::size_t i = 0; i < frfs.frfs.size(); ++i) {
    const Frf& candidate = frfs.frfs[i];
    const auto same = [](const Dof& a, const Dof& b) {
      return a.node == b.node && a.component == b.component;
    };
    if (i != frf && same(candidate.response, wanted.reference) &&
        same(candidate.reference, wanted.response)) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace tapfit::tui
