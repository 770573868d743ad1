#include "tui/document/drawing_text.hpp"

#include "tui/document/svg_heat_map.hpp"
#include "tui/document/svg_plot.hpp"
#include "tui/screen/csv_text.hpp"
#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tapfit::tui {
namespace {

using Eigen::Index;

/// Columns of several lengths beside each other.
std::string table_text(const std::vector<NamedNumbers>& columns,
                       char separator) {
  std::vector<std::string> cells;
  Index rows = 0;
  for (const NamedNumbers& column : columns) {
    cells.push_back(column.heading);
    rows = std::max(rows, column.values.size());
  }
  std::string text = csv_row(cells, separator);
  for (Index row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const Eigen::VectorXd& values = columns[c].values;
      cells[c] = row < values.size() ? csv_number(values[row]) : std::string();
    }
    text += csv_row(cells, separator);
  }
  return text;
}

std::string with_unit(const std::string& name, const Axis& axis) {
  return axis.unit.empty() ? name : fmt::format("{} [{}]", name, axis.unit);
}

/// The rows whose x is drawn.
std::vector<Index> drawn_rows(const Curve& curve, const Axis& x) {
  const bool whole = !(x.lo < x.hi);
  std::vector<Index> rows;
  for (Index i = 0; i < curve.x.size(); ++i) {
    const double at = curve.x[i];
    if (whole || (at >= x.lo && at <= x.hi)) rows.push_back(i);
  }
  return rows;
}

/// "measured"; of curves without a name what the axis shows, counted.
std::string name_of(const Curve& curve, const Plot& plot, int& unnamed) {
  if (!curve.label.empty()) return curve.label;
  ++unnamed;
  return unnamed == 1 ? plot.y.label
                      : fmt::format("{} {}", plot.y.label, unnamed);
}

void add_curve(std::vector<NamedNumbers>& columns,
               const Curve& curve,
               const Plot& plot,
               const std::string& name) {
  const std::vector<Index> rows = drawn_rows(curve, plot.x);
  const auto add = [&](const std::string& what, const Eigen::VectorXd& values) {
    if (values.size() != curve.x.size() || values.size() == 0) return;
    columns.push_back({with_unit(what, plot.y), values(rows)});
  };
  if (curve.numbers.size() > 0) {
    columns.push_back({curve.quantity, curve.numbers(rows)});
    return;
  }
  add(name, curve.y);
  add(name + " low", curve.low);
  add(name + " high", curve.high);
}

/// Points that stand by themselves, glyph by glyph.
void add_spots(std::vector<NamedNumbers>& columns, const Plot& plot) {
  std::vector<char32_t> glyphs;
  for (const Spot& spot : plot.spots) {
    if (std::ranges::find(glyphs, spot.glyph) == glyphs.end()) {
      glyphs.push_back(spot.glyph);
    }
  }
  for (const char32_t glyph : glyphs) {
    std::vector<double> x;
    std::vector<double> y;
    for (const Spot& spot : plot.spots) {
      if (spot.glyph != glyph) continue;
      x.push_back(spot.x);
      y.push_back(spot.y);
    }
    std::string name;
    append_utf8(name, glyph);
    const auto meant = plot.meanings.find(glyph);
    if (meant != plot.meanings.end()) name = meant->second;
    const auto n = static_cast<Index>(x.size());
    columns.push_back(
        {with_unit(fmt::format("{} {}", name, plot.x.label), plot.x),
         Eigen::Map<Eigen::VectorXd>(x.data(), n)});
    columns.push_back(
        {with_unit(fmt::format("{} {}", name, plot.y.label), plot.y),
         Eigen::Map<Eigen::VectorXd>(y.data(), n)});
  }
}

std::string table_of(const Plot& plot, char separator) {
  std::vector<NamedNumbers> columns;
  const Eigen::VectorXd* lines = nullptr;
  int unnamed = 0;
  for (const Curve& curve : plot.curves) {
    if (lines == nullptr || lines->size() != curve.x.size() ||
        *lines != curve.x) {
      lines = &curve.x;
      columns.push_back({with_unit(plot.x.label, plot.x),
                         curve.x(drawn_rows(curve, plot.x))});
    }
    add_curve(columns, curve, plot, name_of(curve, plot, unnamed));
  }
  add_spots(columns, plot);
  return table_text(columns, separator);
}

std::string table_of(const PlanePlot& plane, char separator) {
  if (!plane.columns.empty()) return table_text(plane.columns, separator);
  if (plane.x_label.empty()) return {};
  std::vector<NamedNumbers> columns;
  for (const Path& path : plane.paths) {
    const std::string name = path.label.empty() ? "" : path.label + " ";
    columns.push_back({name + plane.x_label, path.x});
    columns.push_back({name + plane.y_label, path.y});
  }
  return table_text(columns, separator);
}

/// What is not for show is left out; shares in % are so here, too.
Eigen::MatrixXd entries(const HeatMap& map) {
  const double factor = map.shortfall ? 1.0 : 100.0;
  const Index first = std::min<Index>(map.first, map.values.cols());
  return factor * map.values.rightCols(map.values.cols() - first);
}

std::vector<std::string> column_names(const HeatMap& map) {
  const auto first = static_cast<std::ptrdiff_t>(
      std::min(static_cast<std::size_t>(map.first), map.column_names.size()));
  return {map.column_names.begin() + first, map.column_names.end()};
}

std::string table_of(const HeatMap& map, char separator) {
  const Eigen::MatrixXd values = entries(map);
  std::vector<std::string> cells = column_names(map);
  cells.insert(cells.begin(), map.title);
  std::string text = csv_row(cells, separator);
  for (Index row = 0; row < values.rows(); ++row) {
    const auto at = static_cast<std::size_t>(row);
    cells.assign(1, at < map.row_names.size() ? map.row_names[at] : "");
    for (const double value : values.row(row)) {
      cells.push_back(csv_number(value));
    }
    text += csv_row(cells, separator);
  }
  return text;
}

constexpr Picture titled{680.0, 360.0, true};

std::string picture_of(const Plot& plot) { return svg_plot(plot, titled); }

std::string picture_of(const PlanePlot& plane) {
  return svg_plane(plane, {680.0, 520.0, true});
}

/// Full colour for what the screen shows hottest.
std::string picture_of(const HeatMap& map) {
  SvgHeatMap picture;
  picture.name = map.title;
  picture.column_title = map.title;
  picture.values = entries(map);
  picture.factor = 1.0;
  picture.full = map.shortfall ? 1.0 : 100.0 * map.scale;
  picture.decimals = map.shortfall ? 3 : 0;
  picture.rows = map.row_names;
  picture.columns = column_names(map);
  return svg_heat_map(picture);
}

}  // namespace

std::string drawing_table(const Drawing& drawing, char separator) {
  return std::visit(
      [separator](const auto& one) { return table_of(one, separator); },
      drawing);
}

std::string drawing_picture(const Drawing& drawing) {
  return std::visit([](const auto& one) { return picture_of(one); }, drawing);
}

std::vector<PlotFile> plot_files(const std::vector<Drawing>& drawings) {
  constexpr std::size_t most = 26;  // a letter each
  std::vector<PlotFile> files;
  for (std::size_t i = 0; i < std::min(drawings.size(), most); ++i) {
    const std::string letter =
        drawings.size() == 1 ? ""
                             : std::string{'-', static_cast<char>('a' + i)};
    files.push_back({letter + ".svg", drawing_picture(drawings[i])});
    std::string table = drawing_table(drawings[i]);
    if (!table.empty()) files.push_back({letter + ".csv", std::move(table)});
  }
  return files;
}

}  // namespace tapfit::tui
