#include "tui/report/report_shapes.hpp"

#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/point_motions.hpp"
#include "tui/document/svg_plot.hpp"
#include "tui/document/svg_structure.hpp"
#include "tui/report/report_verdict.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "tui/widgets/element_grids.hpp"
#include "tui/widgets/wireframe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace tapfit::tui {
namespace {

constexpr std::size_t most_shapes = 12;

/// The model's mesh, or the points of the test's own; nothing where no place is
/// known.
std::optional<Wireframe> tested_structure(const ReportData& data) {
  if (data.model) return wireframe(data.model->deck);
  if (data.bundle.geometry) return wireframe(*data.bundle.geometry);
  return std::nullopt;
}

std::set<int> hit_nodes(const ReportData& data) {
  std::set<int> nodes;
  for (const signal::Frf& frf : data.frfs.frfs) {
    nodes.insert(frf.reference.node);
  }
  for (const acquisition::Run& run : data.bundle.runs) {
    nodes.insert(run.hammer.dof.node);
  }
  return nodes;
}

/// Where sensors stood, with the names of their channels.
std::map<int, std::set<std::string>> sensor_nodes(const ReportData& data) {
  std::map<int, std::set<std::string>> nodes;
  for (const acquisition::Run& run : data.bundle.runs) {
    for (const acquisition::Placement& sensor : run.sensors) {
      nodes[sensor.dof.node].insert(
          data.bundle.channels.at(sensor.channel).name);
    }
  }
  if (data.bundle.modes) {
    for (const Dof& dof : data.modes.dofs) nodes[dof.node].insert(name(dof));
  }
  if (nodes.empty()) {
    for (const signal::Frf& frf : data.frfs.frfs) {
      nodes[frf.response.node].insert(name(frf.response));
    }
  }
  return nodes;
}

/// Where an effect sits; of a channel's the points of its sensors.
std::set<int> nodes_at(const ReportData& data, const updating::Location& at) {
  std::set<int> nodes(at.nodes.begin(), at.nodes.end());
  if (at.node != 0) nodes.insert(at.node);
  const std::vector<int> corners = element_grids(data.model->deck, at.elements);
  nodes.insert(corners.begin(), corners.end());
  if (at.channels.empty()) return nodes;
  for (const auto& [node, names] : sensor_nodes(data)) {
    if (std::ranges::find_first_of(names, at.channels) != names.end()) {
      nodes.insert(node);
    }
  }
  return nodes;
}

/// Grids where something was found: few, each by itself.
std::set<int> found_nodes(const ReportData& data) {
  std::set<int> nodes;
  if (!data.model) return nodes;
  for (const updating::Rung& rung : effect_rungs(data.model->ladder)) {
    nodes.merge(nodes_at(data, rung.where));
  }
  return nodes;
}

/// What was found at those grids.
std::string found_at_places(const ReportData& data) {
  std::vector<std::string> names;
  for (const updating::Rung& rung : effect_rungs(data.model->ladder)) {
    if (!nodes_at(data, rung.where).empty()) {
      names.push_back(found_words(rung.added, rung.where));
    }
  }
  return enumerated(names);
}

/// Grids that the deck holds against moving. Of a flat model all are held out
/// of plane: that is no support.
std::set<int> clamped_nodes(const ReportData& data) {
  std::set<int> nodes;
  if (!data.model) return nodes;
  const structure::Deck& deck = data.model->deck;
  for (const structure::Constraint& held : deck.constraints) {
    if (held.components.find_first_of("123") != std::string::npos) {
      nodes.insert(held.grid);
    }
  }
  const bool some = 2 * nodes.size() < deck.grids.size();
  return some ? nodes : std::set<int>();
}

Figure sketch(const ReportData& data, const Wireframe& wire) {
  SvgStructure picture;
  picture.name = "structure with hit points and sensors";
  const std::set<int> found = found_nodes(data);
  const auto sensors = sensor_nodes(data);
  const std::set<int> clamped = clamped_nodes(data);
  for (const int node : clamped) {
    picture.marks.push_back({node, "", ink::grey, 5.0});
  }
  for (const int node : found) {
    const bool named = found.size() == 1 && !sensors.contains(node);
    // Larger than the sensor that would hide it.
    const bool large = found.size() < 10 || sensors.contains(node);
    picture.marks.push_back(
        {node, named ? "found" : "", ink::green, large ? 9.0 : 4.5});
  }
  constexpr std::size_t few = 12;
  for (const auto& [node, names] : sensors) {
    std::string label;
    for (const std::string& one : names) {
      label += (label.empty() ? "" : ", ") + one;
    }
    if (found.contains(node) && found.size() == 1) label += ": found";
    picture.marks.push_back(
        {node, sensors.size() <= few ? label : "", ink::blue, 6.0});
  }
  const std::set<int> hits = hit_nodes(data);
  for (const int node : hits) {
    picture.marks.push_back({node,
                             hits.size() <= 30 && !sensors.contains(node)
                                 ? std::to_string(node)
                                 : "",
                             ink::orange,
                             3.2});
  }
  std::string caption = !hits.empty()
                            ? "Small orange dots: hit points. Blue: sensors."
                        : !sensors.empty() ? "Blue: measured points."
                                           : "No points are known.";
  if (!clamped.empty()) caption += " Grey: held by the deck.";
  if (!found.empty()) {
    caption += fmt::format(" Green: {}.", found_at_places(data));
  }
  return {"set-up", caption, svg_structure(wire, picture)};
}

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
  caption += fmt::format(", model {} Hz, MAC {}",
                         four_digits(pair->model_hz),
                         fixed(pair->mac, 3));
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
      fmt::format("Mode {}: {} Hz", k + 1, four_digits(mode.frequency_hz));
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
          fmt::format("Mode {}: {} Hz", k + 1, four_digits(mode.frequency_hz)),
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

std::optional<Figure> set_up_sketch(const ReportData& data) {
  const std::optional<Wireframe> wire = tested_structure(data);
  if (!wire) return std::nullopt;
  return sketch(data, *wire);
}

std::optional<Figure> place_figure(const ReportData& data,
                                   const updating::Location& where,
                                   const std::string& name) {
  const std::set<int> nodes = nodes_at(data, where);
  if (nodes.empty()) return std::nullopt;
  SvgStructure picture;
  picture.name = "where it sits: " + place_words(where);
  picture.width = 340.0;
  picture.tallest = 260.0;
  constexpr std::size_t few = 4;
  for (const int node : nodes) {
    picture.marks.push_back({node,
                             nodes.size() <= few ? std::to_string(node) : "",
                             ink::green,
                             nodes.size() <= few ? 6.0 : 3.5});
  }
  return Figure{name, "", svg_structure(wireframe(data.model->deck), picture)};
}

Section shape_section(const ReportData& data) {
  Section section{"Mode shapes", {}};
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
