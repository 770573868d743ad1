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

/// The shape of the model's mode that is paired with it.
/// @return what the measured shape is to be multiplied by
double add_model_shape(const updating::Comparison& now,
                       std::size_t k,
                       const Eigen::VectorXd& phi,
                       SvgShape& shape,
                       std::string& caption) {
  const updating::ModePair* pair = pair_of_mode(now, static_cast<int>(k));
  if (pair == nullptr || pair->model >= now.modes.at_grids.cols()) {
    caption += ", no mode of the model is paired with it";
    return 1.0;
  }
  const Eigen::VectorXd u = now.modes.at_grids.col(pair->model);
  shape.grids = Eigen::Map<const Eigen::Matrix3Xd>(u.data(), 3, u.size() / 3);
  caption += fmt::format(
      ", model {} Hz, MAC {}", number(pair->model_hz), fixed(pair->mac, 3));
  return modal::factor_onto(now.modes.at_dofs.col(pair->model), phi);
}

Figure structure_figure(const ReportData& data,
                        const Wireframe& wire,
                        std::size_t k) {
  const modal::Mode& mode = data.modes.modes[k];
  const Eigen::VectorXd phi = modal::real_shape(mode.shape);
  SvgShape shape;
  shape.name = fmt::format("shape of mode {}", k + 1);
  std::string caption =
      fmt::format("Mode {}: {} Hz", k + 1, number(mode.frequency_hz));
  const double factor =
      data.model ? add_model_shape(data.model->after, k, phi, shape, caption)
                 : 1.0;
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

std::optional<Wireframe> tested_structure(const ReportData& data) {
  if (data.model) return wireframe(data.model->deck);
  if (data.bundle.geometry) return wireframe(*data.bundle.geometry);
  return std::nullopt;
}

Section shape_section(const ReportData& data) {
  Section section{"Mode shapes", {}, true};
  FigureRow row;
  const std::size_t shown = std::min(data.modes.modes.size(), most_shapes);
  const std::optional<Wireframe> wire = tested_structure(data);
  for (std::size_t k = 0; k < shown; ++k) {
    row.figures.push_back(wire ? structure_figure(data, *wire, k)
                               : list_figure(data, k));
  }
  section.parts.emplace_back(row);
  std::string words = data.model
                          ? "Orange: measured points. Blue: the updated model. "
                            "Grey: at rest. The scale is arbitrary."
                      : wire ? "Orange: measured points and how they move. The "
                               "scale is arbitrary."
                             : order_of_points(data.modes.dofs);
  if (shown < data.modes.modes.size()) {
    words += fmt::format(
        " The first {} of {} modes are shown.", shown, data.modes.modes.size());
  }
  section.parts.emplace_back(Paragraph{words, Paragraph::Kind::Small});
  return section;
}

}  // namespace tapfit::tui
