#include "tui/report/report_shapes.hpp"

#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/point_motions.hpp"
#include "tui/document/svg_plot.hpp"
#include "tui/document/svg_structure.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

constexpr std::size_t most_shapes = 12;

const updating::ModePair* pair_of_mode(const updating::Comparison& comparison,
                                       int mode) {
  for (const updating::ModePair& pair : comparison.pairs) {
    if (pair.measured == mode) return &pair;
  }
  return nullptr;
}

Figure structure_figure(const ReportData& data,
                        const Wireframe& wire,
                        std::size_t k) {
  const modal::Mode& mode = data.modes.modes[k];
  const updating::Comparison& now = data.model->after;
  const updating::ModePair* pair = pair_of_mode(now, static_cast<int>(k));
  const Eigen::VectorXd phi = modal::real_shape(mode.shape);
  SvgShape shape;
  shape.name = fmt::format("shape of mode {}", k + 1);
  double factor = 1.0;
  std::string caption =
      fmt::format("Mode {}: {} Hz", k + 1, number(mode.frequency_hz));
  const auto grids = wire.points.cols();
  if (pair != nullptr && pair->model < now.modes.at_grids.cols() &&
      now.modes.at_grids.rows() == 3 * grids) {
    const Eigen::VectorXd u = now.modes.at_grids.col(pair->model);
    shape.grids = Eigen::Map<const Eigen::Matrix3Xd>(u.data(), 3, grids);
    factor = modal::factor_onto(now.modes.at_dofs.col(pair->model), phi);
    caption += fmt::format(
        ", model {} Hz, MAC {}", number(pair->model_hz), fixed(pair->mac, 3));
  } else {
    caption += ", no mode of the model is paired with it";
  }
  shape.points =
      along_basic(wire, modal::point_motions(data.modes, factor * phi));
  return {fmt::format("mode-{}", k + 1), caption, svg_shape(wire, shape)};
}

Figure list_figure(const ReportData& data, std::size_t k) {
  const modal::Mode& mode = data.modes.modes[k];
  const Eigen::VectorXd phi = modal::real_shape(mode.shape);
  const double most = std::max(phi.cwiseAbs().maxCoeff(), 1e-300);
  const Eigen::Index n = phi.size();
  Plot plot;
  plot.title = fmt::format("shape of mode {}", k + 1);
  plot.x = {"point, in order", "", 0.0, static_cast<double>(n) + 1.0, false};
  plot.y = {"motion", "", -1.1, 1.1, false};
  const Eigen::VectorXd at =
      Eigen::VectorXd::LinSpaced(n, 1.0, static_cast<double>(n));
  const Pen thin{Colour::Grey, Pattern::Solid, '.', true};
  plot.curves = {{"", at, phi / most, {}, {}, thin},
                 {"", at, phi / most, {}, {}, {Colour::Blue}, false}};
  return {fmt::format("mode-{}", k + 1),
          fmt::format("Mode {}: {} Hz", k + 1, number(mode.frequency_hz)),
          svg_plot(plot, {420.0, 220.0})};
}

std::string order_of_points(const std::vector<Dof>& dofs) {
  std::string text = "Order of the points: ";
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    text += (k == 0 ? "" : ", ") + name(dofs[k]);
  }
  return text + ".";
}

}  // namespace

Section shape_section(const ReportData& data) {
  Section section{"Mode shapes", {}, true};
  FigureRow row;
  const std::size_t shown = std::min(data.modes.modes.size(), most_shapes);
  if (data.model) {
    const Wireframe wire = wireframe(data.model->deck);
    for (std::size_t k = 0; k < shown; ++k) {
      row.figures.push_back(structure_figure(data, wire, k));
    }
  } else {
    for (std::size_t k = 0; k < shown; ++k) {
      row.figures.push_back(list_figure(data, k));
    }
  }
  section.parts.emplace_back(row);
  std::string words = data.model
                          ? "Orange: measured points. Blue: the updated model. "
                            "Grey: at rest. The scale is arbitrary."
                          : order_of_points(data.modes.dofs);
  if (shown < data.modes.modes.size()) {
    words += fmt::format(
        " The first {} of {} modes are shown.", shown, data.modes.modes.size());
  }
  section.parts.emplace_back(Paragraph{words, Paragraph::Kind::Small});
  return section;
}

}  // namespace tapfit::tui
