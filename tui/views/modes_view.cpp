#include "tui/views/modes_view.hpp"

#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/mac.hpp"
#include "modal/mode_set/point_motions.hpp"
#include "tui/report/modes_text.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/bars.hpp"
#include "tui/widgets/heat_map.hpp"
#include "tui/widgets/mac_map.hpp"
#include "tui/widgets/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

constexpr const char* no_shapes = "no shapes were given: frequencies alone";

Colour letter_colour(char letter) {
  if (letter == 's') return Colour::Green;
  if (letter == 'v') return Colour::Sky;
  if (letter == 'd') return Colour::Orange;
  return Colour::Grey;
}

bool has_cmif(const ModesInput& input) {
  return input.cmif != nullptr && input.cmif->size() > 0 &&
         input.cmif->rows() == input.frfs->lines();
}

/// What is seen behind the diagram: the CMIF's curves, or the mean |H|.
Eigen::MatrixXd indicators(const ModesInput& input) {
  if (has_cmif(input)) {
    return input.cmif->leftCols(std::min<Eigen::Index>(input.cmif->cols(), 3));
  }
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(input.frfs->lines(), 1);
  for (const signal::Frf& frf : input.frfs->frfs) {
    if (frf.H.size() == mean.rows()) mean.col(0) += frf.H.cwiseAbs();
  }
  return mean /
         static_cast<double>(std::max<std::size_t>(input.frfs->frfs.size(), 1));
}

/// Curves on a logarithmic scale of their own, laid into the diagram's orders.
std::vector<Curve> background(const ModesInput& input, double orders) {
  const Eigen::VectorXd f = input.frfs->frequency_hz();
  const Eigen::MatrixXd values = indicators(input);
  if (values.size() == 0 || !(values.col(0).maxCoeff() > 0.0)) return {};
  const double top = std::log10(values.maxCoeff());
  const double lowest = std::max(values.minCoeff(), 1e-5 * values.maxCoeff());
  const double span = std::max(top - std::log10(lowest), 1e-9);
  std::vector<Curve> curves;
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    Curve curve{"", f, {}, {}, {}, {Colour::Grey, Pattern::Solid, '.', c > 0}};
    const Eigen::ArrayXd level =
        values.col(c).array().max(1e-300).log10() - std::log10(lowest);
    curve.y = orders * level.max(0.0) / span;
    curve.quantity =
        (has_cmif(input) ? fmt::format("CMIF {}", c + 1) : "mean |H|") +
        fmt::format(" [{}]", accelerance_unit);
    curve.numbers = values.col(c);
    curves.push_back(std::move(curve));
  }
  return curves;
}

void draw_diagram(Screen& screen,
                  const Rect& rect,
                  const ModesInput& input,
                  const ModesState& state,
                  std::size_t selected) {
  Plot plot;
  FrequencySpan span;
  int orders = 10;
  for (const modal::DiagramPole& pole : input.modes.diagram) {
    orders = std::max(orders, pole.order);
    span.hi = std::max(span.hi, pole.frequency_hz);
    const Style style{.colour = letter_colour(pole.letter)};
    plot.spots.push_back({pole.frequency_hz,
                          static_cast<double>(pole.order),
                          static_cast<char32_t>(pole.letter),
                          style});
  }
  if (input.frfs != nullptr && input.frfs->lines() > 1) {
    span = frequency_span(*input.frfs);
    plot.curves = background(input, orders);
  }
  for (const modal::Mode& mode : input.modes.modes) {
    span.hi = std::max(span.hi, mode.frequency_hz);
  }
  const PlotRange shown = resolved(state.range, span.lo, span.hi);
  plot.x = {"f", "Hz", shown.lo, shown.hi, false};
  plot.y = {"order", "", 0.0, orders + 1.0, false};
  plot.meanings = {{U'o', "new pole"},
                   {U'f', "stable frequency"},
                   {U'd', "stable frequency and damping"},
                   {U'v', "stable frequency and vector"},
                   {U's', "stable pole"}};
  const bool cmif = input.frfs != nullptr && has_cmif(input);
  plot.title = cmif ? "stabilisation over CMIF" : "stabilisation over mean |H|";
  if (shown.cursor_set) {
    plot.cursor = shown.cursor;
    plot.title += fmt::format("   {} Hz, p picks", number(shown.cursor, 6));
  }
  for (std::size_t i = 0; i < input.modes.modes.size(); ++i) {
    Style style{.colour = Colour::Yellow, .bold = true};
    style.reverse = i == selected;
    plot.markers.push_back({input.modes.modes[i].frequency_hz, U'▼', style});
  }
  draw_plot(screen, rect, plot);
}

void draw_shape_bars(Screen& screen,
                     const Rect& rect,
                     const modal::ModeSet& modes,
                     std::size_t selected) {
  const Eigen::VectorXd shape = modal::real_shape(modes.modes[selected].shape);
  const double largest = shape.size() > 0 ? shape.cwiseAbs().maxCoeff() : 0.0;
  const auto rows =
      std::min<Eigen::Index>({shape.size(),
                              static_cast<Eigen::Index>(modes.dofs.size()),
                              rect.height});
  for (Eigen::Index i = 0; i < rows; ++i) {
    const int y = rect.y + static_cast<int>(i);
    const double share = largest > 0.0 ? shape[i] / largest : 0.0;
    screen.text_right(
        rect.x + 7, y, tapfit::name(modes.dofs[static_cast<std::size_t>(i)]));
    screen.put(rect.x + 8, y, share < 0.0 ? U'-' : U'+');
    screen.text(rect.x + 9,
                y,
                bar(std::abs(share), rect.width - 10, screen.ascii()),
                {.colour = share < 0.0 ? Colour::Orange : Colour::Blue});
  }
}

/// The one asked for, else the one that is paired.
std::optional<std::size_t> model_mode_of(const ModesInput& input,
                                         const ModesState& state,
                                         std::size_t selected) {
  if (input.comparison == nullptr || input.wire == nullptr) return {};
  const updating::Comparison& c = *input.comparison;
  if (static_cast<Eigen::Index>(selected) >= c.mac.rows()) return {};
  const auto count = static_cast<std::size_t>(
      std::min(c.mac.cols(), c.modes.frequency_hz.size()));
  if (state.model_mode && *state.model_mode < count) return state.model_mode;
  for (const updating::ModePair& pair : c.pairs) {
    if (pair.measured == static_cast<int>(selected) && pair.model >= 0 &&
        static_cast<std::size_t>(pair.model) < count) {
      return static_cast<std::size_t>(pair.model);
    }
  }
  return std::nullopt;
}

void draw_shape(Screen& screen,
                const Rect& rect,
                const ModesInput& input,
                const ModesState& state,
                std::size_t selected) {
  const modal::Mode& mode = input.modes.modes[selected];
  int y = rect.y;
  int x = screen.text(
      rect.x,
      rect.y,
      fmt::format("mode {}: {} Hz", selected + 1, number(mode.frequency_hz, 5)),
      {.colour = Colour::Orange, .bold = true},
      rect.width);
  if (mode.shape.size() == 0) {
    screen.text(rect.x, y + 1, no_shapes, {.colour = Colour::Grey}, rect.width);
    return;
  }
  const std::optional<std::size_t> model =
      state.model ? model_mode_of(input, state, selected) : std::nullopt;
  if (model) {
    const updating::Comparison& c = *input.comparison;
    const auto row = static_cast<Eigen::Index>(selected);
    const auto column = static_cast<Eigen::Index>(*model);
    const std::string hz = number(c.modes.frequency_hz[column], 5);
    const std::string mac = fixed(c.mac(row, column), 3);
    const std::string words =
        fitting({fmt::format("over model {} Hz, MAC {}", hz, mac),
                 fmt::format("model {} Hz, MAC {}", hz, mac)},
                rect.width);
    const bool fits = x + 1 + text_width(words) <= rect.x + rect.width;
    x = fits ? x + 1 : rect.x;
    y += fits ? 0 : 1;
    screen.text(x, y, words, {.colour = Colour::Blue}, rect.x + rect.width - x);
  }
  const Rect body = split_top(rect, y + 1 - rect.y).second;
  if (input.wire == nullptr) {
    draw_shape_bars(screen, body, input.modes, selected);
    return;
  }
  Scene scene;
  scene.stems = along_basic(
      *input.wire,
      modal::point_motions(input.modes, modal::real_shape(mode.shape)));
  if (model) {
    scene.shape = model_shape(input.modes, selected, *input.comparison, *model);
  }
  scene.phase = state.phase;
  draw_wireframe(screen, body, *input.wire, scene, state.pose);
}

void draw_mac(Screen& screen,
              const Rect& rect,
              const ModesInput& input,
              const ModesState& state,
              std::size_t selected) {
  if (input.modes.dofs.empty()) {
    screen.text(
        rect.x, rect.y, no_shapes, {.colour = Colour::Grey}, rect.width);
    return;
  }
  HeatMap map;
  const auto count = static_cast<Eigen::Index>(input.modes.modes.size());
  const updating::Comparison* c = input.comparison;
  const bool with_model = c != nullptr && c->mac.rows() == count;
  if (with_model) {
    map = mac_map(c->mac, c->modes.frequency_hz);
  } else {
    const auto dofs = static_cast<Eigen::Index>(input.modes.dofs.size());
    Eigen::MatrixXcd shapes(dofs, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::VectorXcd& shape =
          input.modes.modes[static_cast<std::size_t>(i)].shape;
      if (shape.size() != dofs) return;
      shapes.col(i) = shape;
    }
    map.title = "AutoMAC in %: measured with measured";
    map.values = modal::mac(shapes, shapes);
    for (const modal::Mode& mode : input.modes.modes) {
      map.column_names.push_back(
          fitted(mode.frequency_hz, map.entry_width - 1));
    }
  }
  for (const modal::Mode& mode : input.modes.modes) {
    map.row_names.push_back(fixed(mode.frequency_hz, 2));
  }
  const std::string rigid =
      with_model ? rigid_words(c->modes.frequency_hz) : "";
  screen.text(rect.x,
              rect.y,
              with_model
                  ? fitting({"MAC in %: measured (rows, Hz) with model" + rigid,
                             "MAC in %" + rigid},
                            rect.width)
                  : map.title,
              {.bold = true},
              rect.width);
  map.selected = static_cast<int>(selected);
  map.column =
      std::clamp(static_cast<int>(state.mac_column),
                 map.first,
                 std::max(static_cast<int>(map.values.cols()) - 1, map.first));
  const Rect body = split_top(rect, 1).second;
  scroll_to_mark(map, body);
  draw_heat_map(screen, body, map);
}

std::string summary(const modal::ModeSet& modes) {
  // A test of modes: they were fitted to nothing.
  if (!modes.modes.empty() && modes.synthesis_error == 0.0 &&
      modes.diagram.empty()) {
    return fmt::format("{} modes, as given", modes.modes.size());
  }
  const std::string before = modes.modes.empty()
                                 ? ""
                                 : fmt::format(" ({} before refinement)",
                                               percent(modes.unrefined_error));
  return fmt::format("{} modes, {}, synthesis error {}{}",
                     modes.modes.size(),
                     modes.scaled ? "unit modal mass" : "not scaled",
                     percent(modes.synthesis_error),
                     before);
}

// The first warning below the summary, in at most two rows; what moves the
// poles comes before all others.
int draw_warning(Screen& screen, const ModesInput& input) {
  std::vector<std::string> warnings = input.modes.warnings;
  if (!input.shifts.empty()) warnings.insert(warnings.begin(), input.shifts);
  if (warnings.empty()) return 0;
  std::string text = "! " + warnings.front();
  const int width = screen.width() - 2;
  std::vector<std::string> lines = wrapped(text, width, 2);
  if (warnings.size() > 1) {
    // However long the first one is, that there are others is said.
    const std::string more =
        fmt::format(" (and {} more in the report)", warnings.size() - 1);
    lines.back() = clipped(lines.back(), width - text_width(more)) + more;
  }
  int rows = 0;
  for (const std::string& line : lines) {
    screen.text(1, 1 + rows++, line, {.colour = Colour::Yellow});
  }
  return rows;
}

}  // namespace

Table mode_table(const modal::ModeSet& modes) {
  Table table{{{"#", true}, {"f Hz", true}, {"damping %", true}, {"MPC", true}},
              {}};
  table.sortable = true;
  for (std::size_t i = 0; i < modes.modes.size(); ++i) {
    const modal::Mode& mode = modes.modes[i];
    table.rows.push_back({{std::to_string(i + 1),
                           with_sd(mode.frequency_hz, mode.frequency_sd_hz, 1),
                           damping_words(mode, 1),
                           mpc_words(mode)},
                          {}});
  }
  return table;
}

Eigen::Matrix3Xd model_shape(const modal::ModeSet& modes,
                             std::size_t measured,
                             const updating::Comparison& c,
                             std::size_t model) {
  const auto column = static_cast<Eigen::Index>(model);
  const Eigen::VectorXd shape =
      modal::real_shape(modes.modes.at(measured).shape);
  if (column >= c.modes.at_grids.cols() || column >= c.modes.at_dofs.cols() ||
      c.modes.at_dofs.rows() != shape.size() ||
      c.modes.at_grids.rows() % 3 != 0) {
    return {};
  }
  const Eigen::VectorXd scaled =
      modal::factor_onto(shape, c.modes.at_dofs.col(column)) *
      c.modes.at_grids.col(column);
  return scaled.reshaped(3, scaled.size() / 3);
}

Screen modes_view(const ModesInput& input,
                  const ModesState& state,
                  const Canvas& canvas) {
  Screen screen(canvas);
  const Table table = mode_table(input.modes);
  screen.text(1, 0, summary(input.modes), {}, canvas.width - 2);
  const int top = 1 + draw_warning(screen, input);
  const Rect body{0, top, canvas.width, canvas.height - top};
  if (input.modes.modes.empty()) {
    screen.text(
        1, top + 1, "No mode was found; the diagram shows what was tried.");
    draw_diagram(screen, split_top(body, 3).second, input, state, 0);
    return screen;
  }
  const std::size_t selected = settled(table, state.list);
  const int left = std::clamp(canvas.width / 2, 50, 60);
  if (state.mac) {
    const auto [side, rest] = split_left(body, canvas.width < 110 ? 24 : left);
    draw_table(screen, side, table, state.list, true);
    draw_mac(screen, rest, input, state, selected);
    return screen;
  }
  // Of modes that were given there are neither poles nor FRFs.
  const bool diagram = !input.modes.diagram.empty() ||
                       (input.frfs != nullptr && input.frfs->lines() > 1);
  const auto [upper, lower] =
      split_top(body, diagram ? (body.height - 1) / 2 : body.height);
  const auto [side, shape] = split_left(upper, left);
  draw_table(screen, side, table, state.list, true);
  draw_shape(screen, shape, input, state, selected);
  if (diagram) draw_diagram(screen, lower, input, state, selected);
  return screen;
}

}  // namespace tapfit::tui
