#include "tui/views/compare_view.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/bars.hpp"
#include "tui/widgets/heat_map.hpp"
#include "tui/widgets/level_marks.hpp"
#include "tui/widgets/mac_map.hpp"
#include "tui/widgets/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

using Focus = CompareState::Focus;

/// What the keys move in stands out.
Style heading(bool focused) {
  return focused ? Style{.colour = Colour::Sky, .bold = true}
                 : Style{.colour = Colour::Grey};
}

/// From so many columns on, all panes are shown.
constexpr int all_at_once = 180;

double value_or_nan(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : std::nan("");
}

/// Names the bands by their upper end, as precisely as the columns have room:
/// a band left out could be the one that fails.
void name_bands(HeatMap& map,
                const Rect& rect,
                const std::vector<updating::BandError>& bands) {
  const bool wide = fitting_columns(rect, map) >= map.values.cols();
  if (!wide) map.entry_width = 4;
  for (const updating::BandError& band : bands) {
    map.column_names.push_back(fitted(band.high_hz, map.entry_width - 1));
  }
}

/// Cold where bars are green, hottest at ten times the floor. Without a
/// floor the largest error is the hottest.
void anchor(HeatMap& map, double floor) {
  constexpr double hottest = 10.0;
  if (std::isfinite(floor) && floor > 0.0) {
    map.cold = near_floor * floor;
    map.scale = hottest * floor;
    return;
  }
  double largest = 1e-12;
  for (const double v : map.values.reshaped()) {
    if (std::isfinite(v)) largest = std::max(largest, v);
  }
  map.scale = largest;
}

void draw_error_map(Screen& screen,
                    const Rect& rect,
                    const CompareInput& input,
                    const ListState& list,
                    std::size_t band,
                    bool focused) {
  const updating::Comparison& c = input.comparison;
  if (c.frf_band_error.size() == 0) return;
  HeatMap map;
  map.title = "error [%] by band (upper edge, Hz)";
  const std::vector<std::size_t> order = frf_order(input, list);
  map.values = c.frf_band_error(order, Eigen::all);
  for (const std::size_t frf : order) {
    map.row_names.push_back(signal::name(input.frfs.frfs[frf]));
  }
  name_bands(map, rect, c.bands);
  anchor(map, c.floor);
  const int rows = rect.height - 2;
  const std::size_t selected = settled(compared_frfs(input), list);
  map.selected =
      static_cast<int>(std::ranges::find(order, selected) - order.begin());
  if (focused) map.column = static_cast<int>(band);
  map.top = std::clamp(map.selected - rows / 2,
                       0,
                       std::max(static_cast<int>(map.values.rows()) - rows, 0));
  screen.text(rect.x + 1, rect.y, map.title, heading(focused), rect.width - 1);
  draw_heat_map(screen, split_top(rect, 1).second, map);
}

/// Four steps from the best to the worst point.
const LevelMark& error_mark(double error, double largest) {
  const double share = largest > 0.0 ? error / largest : 0.0;
  return level_marks[share > 0.75 ? 3 : share > 0.5 ? 2 : share > 0.25 ? 1 : 0];
}

void draw_points(Screen& screen,
                 const Rect& rect,
                 const CompareInput& input,
                 const CompareState& state) {
  const auto points = worst_points(input.comparison);
  if (input.wire == nullptr || points.empty()) return;
  const std::size_t selected = std::min(state.point, points.size() - 1);
  Scene scene;
  scene.value_name = "error [%]";
  for (std::size_t i = points.size(); i-- > 0;) {
    const auto& [node, error] = points[i];
    const LevelMark& level = error_mark(error, points[0].second);
    Mark mark{node, level.glyph, {.colour = level.colour}, ""};
    mark.style.reverse = i == selected;
    mark.style.bold = i == selected;
    mark.value = 100.0 * error;
    if (i == selected) mark.label = fmt::format("{}: {}", node, percent(error));
    scene.marks.push_back(std::move(mark));
  }
  // The selected one on top, so that its label is not drawn over.
  std::stable_partition(scene.marks.begin(),
                        scene.marks.end(),
                        [](const Mark& m) { return m.label.empty(); });
  screen.text(rect.x + 1,
              rect.y,
              "error at the measured points",
              heading(state.focus == Focus::Structure),
              rect.width - 1);
  const auto [body, lines] =
      split_top(split_top(rect, 1).second, rect.height - 3);
  draw_wireframe(screen, body, *input.wire, scene, state.pose);
  std::vector<std::string> worst;
  for (std::size_t i = 0; i < std::min<std::size_t>(points.size(), 3); ++i) {
    worst.push_back(
        fmt::format("{} {}", points[i].first, percent(points[i].second)));
  }
  screen.text(lines.x + 1,
              lines.y,
              listed("worst: ", worst, ", ", lines.width - 1),
              {.colour = Colour::Grey},
              lines.width - 1);
  int x = lines.x + 1;
  for (const auto& [share, words_of] : {std::pair{0.2, "≤25"},
                                        {0.4, "≤50"},
                                        {0.6, "≤75"},
                                        {1.0, ">75 % of max"}}) {
    const LevelMark& level = error_mark(share, 1.0);
    screen.put(x, lines.y + 1, level.glyph, {.colour = level.colour});
    x = screen.text(x + 2, lines.y + 1, words_of, {.colour = Colour::Grey}) + 2;
  }
}

void draw_mac(Screen& screen,
              const Rect& rect,
              const CompareInput& input,
              const CompareState& state) {
  const updating::Comparison& c = input.comparison;
  screen.text(rect.x + 1,
              rect.y,
              fitting({"MAC in %: measured (rows, Hz) with model" +
                           rigid_words(c.modes.frequency_hz),
                       "MAC in %" + rigid_words(c.modes.frequency_hz)},
                      rect.width - 1),
              heading(state.focus == Focus::Mac),
              rect.width - 1);
  HeatMap map = mac_map(c.mac, c.modes.frequency_hz);
  for (const double hz : measured_hz(input)) {
    map.row_names.push_back(fixed(hz, 2));
  }
  map.selected = static_cast<int>(state.mac_row);
  map.column = std::max(static_cast<int>(state.mac_column), map.first);
  const Rect body = split_top(rect, 1).second;
  scroll_to_mark(map, body);
  draw_heat_map(screen, body, map);
  screen.name_pane(body, static_cast<std::size_t>(Focus::Mac));
}

void draw_pairs(Screen& screen,
                const Rect& rect,
                const CompareInput& input,
                const CompareState& state) {
  draw_table(screen,
             rect,
             compared_table(compared_modes(input)),
             state.pairs,
             state.focus == Focus::Pairs);
  screen.name_pane(rect, static_cast<std::size_t>(Focus::Pairs));
}

void draw_right(Screen& screen,
                const Rect& rect,
                const CompareInput& input,
                const CompareState& state) {
  if (state.focus == Focus::Structure) {
    draw_points(screen, rect, input, state);
  } else if (state.focus == Focus::Mac) {
    draw_mac(screen, rect, input, state);
  } else {
    draw_pairs(screen, rect, input, state);
  }
}

/// A test of modes has no curves: pairs, and beside them the MAC.
void draw_modes_alone(Screen& screen,
                      const Rect& rect,
                      const CompareInput& input,
                      const CompareState& state) {
  const auto [title, body] = split_top(rect, 1);
  screen.text(1,
              title.y,
              input.comparison.contour,
              {.colour = Colour::Grey},
              rect.width - 2);
  const bool shapes = input.modes != nullptr && !input.modes->dofs.empty();
  const auto [pairs, mac] =
      split_left(body, shapes ? std::min(44, rect.width / 2) : body.width);
  draw_pairs(screen, pairs, input, state);
  if (shapes) draw_mac(screen, mac, input, state);
}

Plot overlay_plot(const CompareInput& input,
                  const CompareState& state,
                  std::size_t selected) {
  const signal::Frf& frf = input.frfs.frfs[selected];
  const Eigen::VectorXd f = input.frfs.frequency_hz();
  Plot plot = frf_plot(input.frfs, state.range);
  plot.title = signal::name(frf);
  plot.curves.push_back(measured_curve("measured", f, frf, false));
  if (selected < input.comparison.model_frfs.size()) {
    plot.curves.push_back(
        magnitude_curve("model",
                        f,
                        input.comparison.model_frfs[selected],
                        {Colour::Orange, Pattern::Dashed, 'o'}));
  }
  return in_scale(std::move(plot), state.scale);
}

/// What the model leaves of the measured FRF, line by line.
Plot residual_plot(const CompareInput& input,
                   const CompareState& state,
                   std::size_t selected) {
  Plot plot = frf_plot(input.frfs, state.range);
  plot.y.label = "|residual|";
  const Eigen::VectorXcd& measured = input.frfs.frfs[selected].H;
  const Eigen::VectorXcd& model = input.comparison.model_frfs[selected];
  if (measured.size() == model.size()) {
    plot.curves.push_back(magnitude_curve(
        "", input.frfs.frequency_hz(), measured - model, {Colour::Purple}));
  }
  return in_scale(std::move(plot), state.scale);
}

/// The selected FRF, measured and of the model; where there is room, what is
/// left between them.
void draw_curves(Screen& screen,
                 const Rect& rect,
                 const CompareInput& input,
                 const CompareState& state,
                 std::size_t selected) {
  Plot plot = overlay_plot(input, state, selected);
  const std::vector<std::string> lines =
      wrapped(plot.cursor ? read_out(plot, *plot.cursor)
                          : contour_words(input.comparison.contour),
              rect.width - 2,
              2);
  const int rows = static_cast<int>(lines.size());
  const auto [body, below] = split_top(rect, rect.height - rows);
  const bool strip =
      body.height >= 20 && selected < input.comparison.model_frfs.size();
  const auto [upper, lower] = split_top(body, body.height - (strip ? 8 : 0));
  plot.x_labels = !strip;
  draw_plot(screen, upper, plot);
  if (strip) draw_plot(screen, lower, residual_plot(input, state, selected));
  for (int i = 0; i < rows; ++i) {
    screen.text(below.x + 1,
                below.y + i,
                lines[static_cast<std::size_t>(i)],
                {.colour = plot.cursor ? Colour::Default : Colour::Grey},
                below.width - 2);
  }
}

}  // namespace

Table compared_frfs(const CompareInput& input) {
  Table table{{{"FRF"}, {"error", true}, {"FRAC", true}}, {}};
  table.sortable = true;
  for (std::size_t i = 0; i < input.frfs.frfs.size(); ++i) {
    table.rows.push_back({{signal::name(input.frfs.frfs[i]),
                           percent(value_or_nan(input.comparison.frf_error, i)),
                           fixed(value_or_nan(input.comparison.frac, i), 3)},
                          {}});
  }
  return table;
}

std::vector<std::size_t> frf_order(const CompareInput& input,
                                   const ListState& list) {
  ListState all = list;
  all.filter.clear();
  return visible_rows(compared_frfs(input), all);
}

std::vector<std::pair<int, double>> worst_points(
    const updating::Comparison& c) {
  std::vector<std::pair<int, double>> points;
  for (const auto& [node, error] : c.point_error) {
    if (std::isfinite(error)) points.emplace_back(node, error);
  }
  std::stable_sort(
      points.begin(), points.end(), [](const auto& a, const auto& b) {
        return a.second > b.second;
      });
  return points;
}

std::string error_sentence(const updating::Comparison& c) {
  return fmt::format("error {} (floor {}: {})",
                     percent(c.error),
                     percent(c.floor),
                     floor_words(c));
}

Screen compare_view(const CompareInput& input,
                    const CompareState& state,
                    const Canvas& canvas) {
  Screen screen(canvas);
  const updating::Comparison& c = input.comparison;
  const int x =
      screen.text(1, 0, error_sentence(c), {.bold = true}, canvas.width - 2);
  draw_error_bar(screen,
                 {x + 2, 0, std::min(canvas.width - x - 3, 40), 1},
                 c.error,
                 c.floor,
                 std::max({1.2 * c.error, 2.0 * c.floor, 1e-9}));
  if (input.frfs.frfs.empty()) {
    draw_modes_alone(
        screen, {0, 1, canvas.width, canvas.height - 1}, input, state);
    return screen;
  }
  const Table table = compared_frfs(input);
  const std::size_t selected = settled(table, state.list);
  const Rect body{0, 1, canvas.width, canvas.height - 1};
  const auto [upper, lower] = split_top(body, body.height * 9 / 20);
  const bool wide = canvas.width >= 110;
  const auto [first, rest] = split_left(upper, wide ? 32 : 0);
  if (wide) draw_table(screen, first, table, state.list, true);
  const int pane = canvas.width < all_at_once ? 40 : 84;
  const auto [map, right] = split_left(rest, rest.width - pane);
  draw_error_map(
      screen, map, input, state.list, state.band, state.focus == Focus::Map);
  if (canvas.width < all_at_once) {
    draw_right(screen, right, input, state);
    draw_curves(screen, lower, input, state, selected);
    return screen;
  }
  const auto [pairs, mac] = split_left(right, right.width / 2);
  draw_pairs(screen, pairs, input, state);
  draw_mac(screen, mac, input, state);
  const auto [curves, points] = split_left(lower, lower.width * 2 / 3);
  draw_curves(screen, curves, input, state, selected);
  draw_points(screen, points, input, state);
  return screen;
}

}  // namespace tapfit::tui
