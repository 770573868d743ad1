#include "tui/views/update_panels.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/widgets/heat_map.hpp"
#include "tui/widgets/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::tui {
namespace {

using updating::RecordedStep;
using updating::UpdateRecord;

int stage_of(const std::vector<int>& stages, Eigen::Index step) {
  const auto at = static_cast<std::size_t>(step);
  return at < stages.size() ? stages[at] : 0;
}

/// @param stages per step; each is on lines of its own, and so is its curve
Plot error_plot(const std::vector<double>& errors,
                const std::vector<int>& stages = {}) {
  const auto n = static_cast<Eigen::Index>(errors.size());
  Plot plot;
  plot.x = {"step",
            "",
            0.0,
            std::max<double>(static_cast<double>(n) - 1, 1.0),
            false};
  plot.y = {"residual", "", 0.0, 0.0, true};
  for (Eigen::Index begin = 0; begin < n;) {
    Eigen::Index end = begin + 1;
    while (end < n && stage_of(stages, end) == stage_of(stages, begin)) ++end;
    const Eigen::Index count = end - begin;
    const Eigen::VectorXd steps = Eigen::VectorXd::LinSpaced(
        count, static_cast<double>(begin), static_cast<double>(end - 1));
    const Eigen::VectorXd values =
        Eigen::Map<const Eigen::VectorXd>(errors.data() + begin, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      plot.spots.push_back(
          {steps[i], values[i], U'●', {.colour = Colour::Sky}});
    }
    plot.curves.push_back({"", steps, values, {}, {}, {Colour::Sky}});
    begin = end;
  }
  return plot;
}

Pen parameter_pen(std::size_t i) {
  static constexpr std::array<Pen, 6> pens{{
      {Colour::Orange, Pattern::Solid, 'a'},
      {Colour::Sky, Pattern::Dashed, 'b'},
      {Colour::Green, Pattern::Dotted, 'c'},
      {Colour::Purple, Pattern::Solid, 'd'},
      {Colour::Yellow, Pattern::Dashed, 'e'},
      {Colour::Red, Pattern::Dotted, 'f'},
  }};
  Pen pen = pens[i % pens.size()];
  pen.mark = static_cast<char>('a' + i % 26);
  return pen;
}

/// Without colour a letter on each curve tells them apart, each on a step of
/// its own, where it covers no other. In ASCII they are drawn in letters.
Plot parameter_plot(const UpdateRecord& record, bool ascii) {
  Plot plot;
  const auto n = static_cast<Eigen::Index>(record.steps.size());
  plot.x = {"step",
            "",
            0.0,
            std::max<double>(static_cast<double>(n) - 1, 1.0),
            false};
  plot.y = {"value over its last", "", 0.0, 0.0, false};
  for (std::size_t p = 0; p < record.parameters.size(); ++p) {
    const auto at = static_cast<Eigen::Index>(p);
    const Eigen::VectorXd& last = record.steps.back().values;
    if (at >= last.size() || last[at] == 0.0) continue;
    const Pen pen = parameter_pen(p);
    const std::string letter = ascii ? "" : fmt::format("{} ", pen.mark);
    Curve curve{
        letter + parameter_words(record.parameters[p]), {}, {}, {}, {}, pen};
    curve.x = Eigen::VectorXd::LinSpaced(n, 0.0, static_cast<double>(n) - 1.0);
    curve.y.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::VectorXd& values =
          record.steps[static_cast<std::size_t>(i)].values;
      curve.y[i] = at < values.size() ? values[at] / last[at] : std::nan("");
    }
    const auto step = std::min(at, n - 1);
    plot.spots.push_back({curve.x[step],
                          curve.y[step],
                          static_cast<char32_t>(pen.mark),
                          {.colour = pen.colour, .bold = true}});
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

/// "mass 0.0785 ± 0.0006 kg   1.5e-05 ├────●──┤ 1.5", along logarithms.
void draw_live_parameter(Screen& screen,
                         const Rect& line,
                         const updating::LiveParameter& p) {
  const NameAndUnit split = split_unit(p.name);
  const int room = line.width - 1;
  const int words = room / 2;
  // What tells parameters apart stands at a name's end; numbers are not cut.
  const std::string value =
      fmt::format("{} {}", with_sd(p.value, p.sd), split.unit);
  const int left = words - 2 - text_width(value);
  screen.text(line.x + 1,
              line.y,
              left > 3 ? clipped(split.name, left) + " " + value : value);
  const std::string low = number(p.lower, 2);
  const std::string high = number(p.upper, 2);
  const int bar = room - words - text_width(low) - text_width(high) - 2;
  if (bar < 8 || !(p.lower > 0.0) || !(p.upper > p.lower)) return;
  const double share =
      std::log(p.value / p.lower) / std::log(p.upper / p.lower);
  const int at =
      std::clamp(static_cast<int>(std::lround(share * (bar - 1))), 0, bar - 1);
  int x = line.x + 1 + words;
  screen.text(x, line.y, low, {.colour = Colour::Grey});
  x += text_width(low) + 1;
  for (int i = 0; i < bar; ++i) {
    screen.text(
        x + i, line.y, screen.ascii() ? "-" : "─", {.colour = Colour::Grey});
  }
  screen.text(
      x + at,
      line.y,
      screen.ascii() ? "o" : "●",
      {.colour = at == 0 || at == bar - 1 ? Colour::Yellow : Colour::Orange});
  screen.text(x + bar + 1, line.y, high, {.colour = Colour::Grey});
}

Plot live_curves(const updating::LiveFit& live) {
  Plot plot;
  plot.x = {"f [Hz]",
            "",
            live.frequency_hz[0],
            live.frequency_hz[live.frequency_hz.size() - 1],
            false};
  plot.y = {"|H|", "", 0.0, 0.0, true};
  plot.curves.push_back(
      {"measured", live.frequency_hz, live.measured, {}, {}, {Colour::Sky}});
  plot.curves.push_back({"model",
                         live.frequency_hz,
                         live.model,
                         {},
                         {},
                         {Colour::Orange, Pattern::Dashed, 'o'}});
  return plot;
}

}  // namespace

void draw_live_fit(Screen& screen,
                   const Rect& rect,
                   const std::vector<double>& errors,
                   const updating::LiveFit& live) {
  // The newest effect's parameters, when not all fit.
  const std::size_t shown = std::min<std::size_t>(
      live.parameters.size(), static_cast<std::size_t>(rect.height) / 4);
  const auto [top, below] = split_top(rect, static_cast<int>(shown));
  for (std::size_t i = 0; i < shown; ++i) {
    draw_live_parameter(screen,
                        {top.x, top.y + static_cast<int>(i), top.width, 1},
                        live.parameters[live.parameters.size() - shown + i]);
  }
  const bool wide = rect.width >= 70;
  const auto [left, right] =
      split_left(below, wide ? rect.width * 2 / 5 : rect.width);
  draw_plot(screen, left, error_plot(errors));
  if (wide && live.frequency_hz.size() > 0) {
    draw_plot(screen, right, live_curves(live));
  }
}

void draw_convergence(Screen& screen,
                      const Rect& rect,
                      const UpdateRecord& record) {
  const std::vector<std::string> words =
      wrapped(fmt::format("fit with {}: {} steps, {}; {}",
                          record.added,
                          record.steps.size(),
                          record.message,
                          on_contour(record.lines)),
              rect.width - 2,
              2);
  const auto [lines, body] = split_top(rect, static_cast<int>(words.size()));
  for (std::size_t i = 0; i < words.size(); ++i) {
    screen.text(lines.x + 1, lines.y + static_cast<int>(i), words[i]);
  }
  if (record.steps.empty()) return;
  std::vector<double> errors;
  std::vector<int> stages;
  for (const RecordedStep& step : record.steps) {
    errors.push_back(step.error);
    stages.push_back(step.stage);
  }
  const auto [upper, lower] = split_top(body, body.height / 2);
  Plot plot = error_plot(errors, stages);
  // Each stage of a fit is on other lines: its error starts anew.
  for (std::size_t i = 1; i < record.steps.size(); ++i) {
    if (record.steps[i].stage == record.steps[i - 1].stage) continue;
    plot.markers.push_back(
        {static_cast<double>(i), U'▼', {.colour = Colour::Yellow}});
    plot.title = "▼ finer frequency set";
  }
  plot.x_labels = false;
  draw_plot(screen, upper, plot);
  draw_plot(screen, lower, parameter_plot(record, screen.ascii()));
}

void draw_correlation(Screen& screen,
                      const Rect& rect,
                      const UpdateRecord& record,
                      const std::string& look_alikes) {
  const auto [line, rest] = split_top(rect, 1);
  HeatMap map;
  map.title = "|correlation| of the estimates in %";
  screen.text(line.x + 1, line.y, map.title, {.bold = true}, line.width - 2);
  map.values = record.correlation.cwiseAbs();
  for (std::size_t i = 0; i < record.parameters.size(); ++i) {
    map.row_names.push_back(
        fmt::format("{} {}", i + 1, parameter_words(record.parameters[i])));
    map.column_names.push_back(std::to_string(i + 1));
  }
  const int rows = static_cast<int>(map.values.rows()) + 1;
  const auto [body, below] =
      split_top(rest, std::min(rows, std::max(rest.height - 2, 0)));
  draw_heat_map(screen, body, map);
  std::string words;
  for (const auto& group : record.confounded) {
    std::vector<std::string> names;
    for (const std::string& name : group) {
      names.push_back(parameter_words(name));
    }
    words += fmt::format("{} {}. ",
                         group.size() > 1 ? "The data cannot tell apart"
                                          : "The data say nothing of",
                         enumerated(names));
  }
  if (words.empty()) words = "All parameters are identifiable. ";
  if (!look_alikes.empty()) {
    words += fmt::format("The effect is {}.", look_alikes);
  }
  const bool unsure = !record.confounded.empty() || !look_alikes.empty();
  int y = below.y + 1;
  for (const std::string& one : wrapped(words, rect.width - 2)) {
    screen.text(rect.x + 1,
                y++,
                one,
                {.colour = unsure ? Colour::Yellow : Colour::Default},
                rect.width - 2);
  }
}

void draw_l_curve(Screen& screen,
                  const Rect& rect,
                  const UpdateRecord& record) {
  if (!record.l_curve || record.l_curve->lambda.size() < 2) {
    int y = rect.y + 1;
    for (const std::string& line : wrapped(
             "Nothing that was fitted here has a prior, so that there is no "
             "lambda to choose.",
             rect.width - 2)) {
      screen.text(rect.x + 1, y++, line, {}, rect.width - 2);
    }
    return;
  }
  const updating::LCurve& l = *record.l_curve;
  Plot plot;
  plot.title = fmt::format("L-curve, corner at lambda {}",
                           number(l.lambda[l.corner], 3));
  if (l.used) {
    plot.title +=
        fmt::format(" (●); the priors' is {} (◆)", number(l.used->lambda, 3));
    plot.spots.push_back({l.used->residual_norm,
                          l.used->solution_norm,
                          U'◆',
                          {.colour = Colour::Green, .bold = true}});
  }
  plot.x = {"|S x - d|",
            "",
            l.residual_norm.minCoeff() / 1.05,
            1.05 * l.residual_norm.maxCoeff(),
            true};
  plot.y = {"|x|", "", 0.0, 0.0, true};
  plot.curves.push_back(
      {"", l.residual_norm, l.solution_norm, {}, {}, {Colour::Sky}});
  plot.spots.push_back({l.residual_norm[l.corner],
                        l.solution_norm[l.corner],
                        U'●',
                        {.colour = Colour::Orange, .bold = true}});
  draw_plot(screen, rect, plot);
}

}  // namespace tapfit::tui
