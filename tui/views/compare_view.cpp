#include "tui/views/compare_view.hpp"

#include "tui/bars.hpp"
#include "tui/heat_map.hpp"
#include "tui/layout.hpp"
#include "tui/number.hpp"
#include "tui/plot.hpp"
#include "tui/text.hpp"
#include "tui/views/frf_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

double value_or_nan(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : std::nan("");
}

Table frf_table(const CompareInput& input) {
  Table table{{{"FRF"}, {"error", true}, {"FRAC", true}}, {}};
  for (std::size_t i = 0; i < input.frfs.frfs.size(); ++i) {
    table.rows.push_back({{signal::name(input.frfs.frfs[i]),
                           percent(value_or_nan(input.comparison.frf_error, i)),
                           fixed(value_or_nan(input.comparison.frac, i), 3)},
                          {}});
  }
  return table;
}

Table pair_table(const updating::Comparison& c) {
  Table table{{{"measured Hz", true},
               {"model Hz", true},
               {"error %", true},
               {"MAC", true}},
              {}};
  for (const updating::ModePair& pair : c.pairs) {
    Style style;
    if (pair.mac < 0.9) style.colour = Colour::Orange;
    table.rows.push_back({{fixed(pair.measured_hz, 3),
                           fixed(pair.model_hz, 3),
                           fmt::format("{}{}",
                                       pair.error_percent > 0 ? "+" : "",
                                       fixed(pair.error_percent, 2)),
                           fixed(pair.mac, 3)},
                          style});
  }
  return table;
}

/// At most three cells, to stand above a narrow column.
std::string short_hz(double hz) {
  if (hz >= 999.5) return fixed(hz / 1000.0, 0) + "k";
  return fixed(hz, hz < 9.95 ? 1 : 0);
}

/// Names the bands by their upper end, as precisely as the columns have room:
/// a band left out could be the one that fails.
void name_bands(HeatMap& map,
                const Rect& rect,
                const std::vector<updating::BandError>& bands) {
  const bool wide = fitting_columns(rect, map) >= map.values.cols();
  if (!wide) map.entry_width = 4;
  for (const updating::BandError& band : bands) {
    map.column_names.push_back(wide ? number(band.high_hz, 3)
                                    : short_hz(band.high_hz));
  }
}

void draw_error_map(Screen& screen,
                    const Rect& rect,
                    const CompareInput& input,
                    std::size_t selected) {
  const updating::Comparison& c = input.comparison;
  if (c.frf_band_error.size() == 0) return;
  HeatMap map;
  map.values = c.frf_band_error;
  for (const signal::Frf& frf : input.frfs.frfs) {
    map.row_names.push_back(signal::name(frf));
  }
  name_bands(map, rect, c.bands);
  double largest = 0.0;
  for (const double v : map.values.reshaped()) {
    if (std::isfinite(v)) largest = std::max(largest, v);
  }
  map.scale = std::max(largest, 1e-12);
  const int rows = rect.height - 2;
  map.selected = static_cast<int>(selected);
  map.top = std::clamp(map.selected - rows / 2,
                       0,
                       std::max(static_cast<int>(map.values.rows()) - rows, 0));
  screen.text(rect.x + 1,
              rect.y,
              "error in %, bands up to Hz",
              {.colour = Colour::Grey},
              rect.width - 1);
  draw_heat_map(screen, split_top(rect, 1).second, map);
}

void draw_points(Screen& screen,
                 const Rect& rect,
                 const CompareInput& input,
                 const CompareState& state) {
  if (input.wire == nullptr) return;
  Scene scene;
  double largest = 1e-12;
  for (const auto& [node, error] : input.comparison.point_error) {
    if (std::isfinite(error)) largest = std::max(largest, error);
  }
  for (const auto& [node, error] : input.comparison.point_error) {
    const bool bad = error > 0.7 * largest;
    scene.marks.push_back({node,
                           U'●',
                           {.colour = bad ? Colour::Red : Colour::Green},
                           fmt::format("{}:{}", node, percent(error))});
  }
  draw_wireframe(screen, rect, *input.wire, scene, state.pose);
}

void draw_overlay(Screen& screen,
                  const Rect& rect,
                  const CompareInput& input,
                  const CompareState& state,
                  std::size_t selected) {
  const signal::Frf& frf = input.frfs.frfs[selected];
  const Eigen::VectorXd f = input.frfs.frequency_hz();
  Plot plot = frf_plot(input.frfs, state.range, state.log);
  plot.title = signal::name(frf);
  plot.curves.push_back(measured_curve("measured", f, frf, false));
  if (selected < input.comparison.model_frfs.size()) {
    plot.curves.push_back(
        magnitude_curve("model",
                        f,
                        input.comparison.model_frfs[selected],
                        {Colour::Orange, Pattern::Dashed, 'o'}));
  }
  const std::vector<std::string> lines = wrapped(
      plot.cursor ? read_out(plot, *plot.cursor) : input.comparison.contour,
      rect.width - 2,
      2);
  const int rows = static_cast<int>(lines.size());
  const auto [body, below] = split_top(rect, rect.height - rows);
  draw_plot(screen, body, plot);
  for (int i = 0; i < rows; ++i) {
    screen.text(below.x + 1,
                below.y + i,
                lines[static_cast<std::size_t>(i)],
                {.colour = plot.cursor ? Colour::Yellow : Colour::Grey},
                below.width - 2);
  }
}

}  // namespace

std::string error_sentence(const updating::Comparison& c) {
  return fmt::format("error {} (floor {}: noise {}, mesh {})",
                     percent(c.error),
                     percent(c.floor),
                     percent(c.floor_noise),
                     percent(c.floor_mesh));
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
  if (input.frfs.frfs.empty()) return screen;
  const Table table = frf_table(input);
  const std::size_t selected = settled(table, state.list);
  const Rect body{0, 1, canvas.width, canvas.height - 1};
  const auto [upper, lower] = split_top(body, body.height * 9 / 20);
  const bool wide = canvas.width >= 110;
  const auto [first, rest] = split_left(upper, wide ? 32 : 0);
  if (wide) draw_table(screen, first, table, state.list, true);
  const auto [map, pairs] = split_left(rest, rest.width - 40);
  draw_error_map(screen, map, input, selected);
  if (state.structure) {
    draw_points(screen, pairs, input, state);
  } else {
    draw_table(screen, pairs, pair_table(c), {}, false);
  }
  draw_overlay(screen, lower, input, state, selected);
  return screen;
}

Screen ComparePage::draw(const Snapshot& known, const Canvas& canvas) const {
  return compare_view(
      {*known.comparison, *known.frfs, known.wire.get()}, state_, canvas);
}

bool ComparePage::press(const Snapshot& known, Key key, Command& command) {
  const CompareInput input{*known.comparison, *known.frfs, known.wire.get()};
  const Table table = frf_table(input);
  if (key == U'x') {
    state_.log = !state_.log;
  } else if (key == keys::tab || key == U'm') {
    state_.structure = !state_.structure;
  } else if (key == keys::enter) {
    command.kind = Command::Kind::ShowFrf;
    command.frf = settled(table, state_.list);
  } else if (!list_key(state_.list, table, key) &&
             !pose_key(state_.pose, key)) {
    const FrequencySpan span = frequency_span(*known.frfs);
    return range_key(
        state_.range, key, span.lo, span.hi, line_spacing(*known.frfs));
  }
  return true;
}

std::vector<KeyHelp> ComparePage::keys() const {
  return {{"j k", "FRF"},
          {"h l", "cursor"},
          {"Tab", "pairs/structure"},
          {"x", "log/linear"},
          {"Enter", "FRF screen"},
          {"+ -", "zoom"},
          {"[ ]", "pan"},
          {"< > ( )", "turn"},
          {"_", "whole band"},
          {"/", "filter"}};
}

std::string ComparePage::help() const {
  return "The error is the root mean square of measured minus model over all "
         "FRFs and lines, each line divided by its mean measured magnitude, "
         "so that resonances and valleys count alike. The floor is what the "
         "scatter over hits and the mesh allow; a bar is green once it is "
         "within 1.3 of its floor. The map says which FRF fails in which "
         "band, the table which mode, the structure which point.";
}

}  // namespace tapfit::tui
