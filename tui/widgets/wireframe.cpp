#include "tui/widgets/wireframe.hpp"

#include "tui/screen/dots.hpp"
#include "tui/screen/text.hpp"
#include "tui/widgets/drawing.hpp"
#include "tui/widgets/structure_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

namespace tapfit::tui {
namespace {

/// Rotation to eye axes: x right, y up, z towards the eye.
Eigen::Matrix3d eye_axes(const Pose& pose) {
  const double a = pose.azimuth_deg * std::numbers::pi / 180.0;
  const double e = pose.elevation_deg * std::numbers::pi / 180.0;
  Eigen::Matrix3d turn;
  turn << std::cos(a), -std::sin(a), 0.0,  //
      std::sin(a), std::cos(a), 0.0,       //
      0.0, 0.0, 1.0;
  Eigen::Matrix3d tilt;
  tilt << 1.0, 0.0, 0.0,              //
      0.0, std::sin(e), std::cos(e),  //
      0.0, -std::cos(e), std::sin(e);
  return tilt * turn;
}

struct Projection {
  Eigen::Matrix3d axes;
  Eigen::Vector3d centre;
  double scale = 1.0;    ///< dots per metre, vertically
  double stretch = 1.0;  ///< horizontal dots per vertical dot
  double x0 = 0.0;
  double y0 = 0.0;

  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d seen = axes * (p - centre);
    return {x0 + scale * stretch * seen.x(), y0 - scale * seen.y()};
  }
};

Projection fit(const Wireframe& wire, const Dots& dots, const Pose& pose) {
  Projection view;
  view.axes = eye_axes(pose);
  const Eigen::Vector3d lo = wire.points.rowwise().minCoeff();
  const Eigen::Vector3d hi = wire.points.rowwise().maxCoeff();
  view.centre = 0.5 * (lo + hi);
  const Eigen::Matrix3Xd seen =
      view.axes * (wire.points.colwise() - view.centre);
  const double half_width = seen.row(0).cwiseAbs().maxCoeff();
  const double half_height = seen.row(1).cwiseAbs().maxCoeff();
  view.stretch = 1.0 / dots.flatness();
  const double margin = 0.84;
  const double by_width =
      0.5 * dots.width() / std::max(half_width * view.stretch, 1e-12);
  const double by_height = 0.5 * dots.height() / std::max(half_height, 1e-12);
  view.scale = margin * pose.zoom * std::min(by_width, by_height);
  if (!std::isfinite(view.scale)) view.scale = 1.0;
  view.x0 = 0.5 * (dots.width() - 1);
  view.y0 = 0.5 * (dots.height() - 1);
  return view;
}

double structure_size(const Wireframe& wire) {
  return (wire.points.rowwise().maxCoeff() - wire.points.rowwise().minCoeff())
      .norm();
}

/// Factor that brings the largest displacement to an eighth of the size.
double shape_factor(const Wireframe& wire, const Scene& scene) {
  double largest = 0.0;
  if (scene.shape.cols() == wire.points.cols() && scene.shape.cols() > 0) {
    largest = scene.shape.colwise().norm().maxCoeff();
  }
  for (const auto& [node, stem] : scene.stems) {
    largest = std::max(largest, stem.norm());
  }
  if (!(largest > 0.0) || !std::isfinite(largest)) return 0.0;
  return scene.phase * structure_size(wire) / 8.0 / largest;
}

/// Lines of which neighbours are far enough apart to be told apart.
std::vector<Edge> legible_lines(const Wireframe& wire,
                                const Projection& view,
                                const Dots& dots) {
  double length = 0.0;
  for (const Edge& edge : wire.lines) {
    length += (view(wire.points.col(edge[0])) - view(wire.points.col(edge[1])))
                  .norm();
  }
  length /= std::max<double>(static_cast<double>(wire.lines.size()), 1.0);
  // A cell in between, about.
  const double least = dots.down() == 1 ? 2.5 : 4.0 * dots.grain();
  int every = 1;
  while (length * every < least && every < 64) every *= 2;
  std::vector<Edge> lines;
  for (std::size_t i = 0; i < wire.lines.size(); ++i) {
    if (wire.ranks[i].depth % every == 0) lines.push_back(wire.lines[i]);
  }
  return lines;
}

/// What a deformed structure is seen against; all of it where it has none.
std::vector<Edge> outline_of(const Wireframe& wire,
                             const std::vector<Edge>& all) {
  std::vector<Edge> lines;
  for (std::size_t i = 0; i < wire.lines.size(); ++i) {
    if (wire.ranks[i].outline) lines.push_back(wire.lines[i]);
  }
  return lines.empty() ? all : lines;
}

void draw_lines(Dots& dots,
                const Projection& view,
                const Eigen::Matrix3Xd& points,
                const std::vector<Edge>& lines,
                const Pen& pen) {
  for (const Edge& edge : lines) {
    const Eigen::Vector2d a = view(points.col(edge[0]));
    const Eigen::Vector2d b = view(points.col(edge[1]));
    dots.line(a.x(), a.y(), b.x(), b.y(), pen);
  }
}

/// Lines of one colour, between points of their own.
struct Layer {
  std::string label;
  Eigen::Matrix3Xd points;
  std::vector<Edge> lines;
  Pen pen;
};

/// From each point to where it moves.
Layer stem_layer(const Wireframe& wire, const Scene& scene, double factor) {
  Layer layer{"measured", {}, {}, {Colour::Orange, Pattern::Solid, '*', false}};
  layer.points.resize(3, 2 * static_cast<Eigen::Index>(scene.stems.size()));
  int next = 0;
  for (const auto& [node, stem] : scene.stems) {
    const auto found = wire.index.find(node);
    if (found == wire.index.end()) continue;
    const Eigen::Vector3d foot = wire.points.col(found->second);
    layer.points.col(next) = foot;
    layer.points.col(next + 1) = foot + factor * stem;
    layer.lines.push_back({next, next + 1});
    next += 2;
  }
  return layer;
}

std::vector<Edge> lines_between(const Wireframe& wire,
                                const std::vector<int>& nodes) {
  std::set<int> wanted;
  for (const int node : nodes) {
    const auto found = wire.index.find(node);
    if (found != wire.index.end()) wanted.insert(found->second);
  }
  std::vector<Edge> lines;
  for (const Edge& edge : wire.lines) {
    if (wanted.contains(edge[0]) && wanted.contains(edge[1])) {
      lines.push_back(edge);
    }
  }
  return lines;
}

/// The structure at rest, a place in it, a shape, and last the stems.
/// @param lines of the structure to draw
std::vector<Layer> layers_of(const Wireframe& wire,
                             const Scene& scene,
                             const std::vector<Edge>& lines) {
  const double factor = shape_factor(wire, scene);
  const bool shaped = scene.shape.cols() == wire.points.cols();
  std::vector<Layer> layers;
  layers.push_back({"at rest",
                    wire.points,
                    shaped ? outline_of(wire, lines) : lines,
                    {Colour::Grey, Pattern::Solid, '.', false}});
  if (!scene.highlighted.empty()) {
    layers.push_back({"place",
                      wire.points,
                      lines_between(wire, scene.highlighted),
                      {Colour::Orange, Pattern::Solid, '#'}});
  }
  if (shaped) {
    layers.push_back({"model",
                      wire.points + factor * scene.shape,
                      lines,
                      {Colour::Blue, Pattern::Solid, '+'}});
  }
  layers.push_back(stem_layer(wire, scene, factor));
  return layers;
}

void draw_feet(Dots& dots, const Projection& view, const Layer& stems) {
  for (const Edge& stem : stems.lines) {
    const Eigen::Vector2d foot = view(stems.points.col(stem[0]));
    dots.foot(foot.x(), foot.y(), stems.pen);
  }
}

/// The same as a drawing, without what cells have no room for left out.
PlanePlot seen(const Wireframe& wire,
               const Scene& scene,
               const Projection& view) {
  PlanePlot plot;
  plot.title = "structure";
  plot.columns = structure_columns(wire, scene);
  const auto flat = [&view](const Eigen::Vector3d& p) -> Eigen::Vector2d {
    return (view.axes * (p - view.centre)).head<2>();
  };
  for (const Layer& layer : layers_of(wire, scene, wire.lines)) {
    if (layer.lines.empty()) continue;
    const auto n = static_cast<Eigen::Index>(3 * layer.lines.size());
    const Eigen::VectorXd gaps =
        Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
    Path path{layer.label, gaps, gaps, layer.pen, true};
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      for (int end = 0; end < 2; ++end) {
        const auto at = static_cast<Eigen::Index>(3 * i) + end;
        const auto which = static_cast<std::size_t>(end);
        const Eigen::Vector2d p = flat(layer.points.col(layer.lines[i][which]));
        path.x[at] = p.x();
        path.y[at] = p.y();
      }
    }
    plot.paths.push_back(std::move(path));
  }
  for (const Mark& mark : scene.marks) {
    const auto found = wire.index.find(mark.node);
    if (found == wire.index.end()) continue;
    const Eigen::Vector2d p = flat(wire.points.col(found->second));
    plot.spots.push_back({p.x(), p.y(), mark.glyph, mark.style, mark.label});
  }
  return plot;
}

void draw_marks(Screen& screen,
                const Rect& rect,
                const Projection& view,
                const Dots& dots,
                const Wireframe& wire,
                const Scene& scene) {
  for (const Mark& mark : scene.marks) {
    const auto found = wire.index.find(mark.node);
    if (found == wire.index.end()) continue;
    const Eigen::Vector2d at = view(wire.points.col(found->second));
    if (!at.allFinite() || at.cwiseAbs().maxCoeff() > 1e6) continue;
    const int x = rect.x + static_cast<int>(std::floor(at.x() / dots.across()));
    const int y = rect.y + static_cast<int>(std::floor(at.y() / dots.down()));
    if (!rect.holds(x, y)) continue;
    screen.put(x, y, mark.glyph, mark.style);
    const int room = rect.x + rect.width - x - 1;
    if (text_width(mark.label) <= room) {
      screen.text(x + 1, y, mark.label, mark.style, room);
    } else {
      screen.text_right(x, y, mark.label, mark.style, x - rect.x);
    }
  }
}

}  // namespace

Wireframe wireframe(const acquisition::TestGeometry& geometry) {
  Wireframe wire;
  wire.points.resize(3, static_cast<Eigen::Index>(geometry.nodes.size()));
  int column = 0;
  for (const auto& [label, at] : geometry.nodes) {
    wire.points.col(column) = at;
    for (const int node : {label, -label}) {
      wire.index[node] = column;
      wire.axes[node] = acquisition::own_point(geometry, label).axes;
    }
    ++column;
  }
  return wire;
}

std::map<int, Eigen::Vector3d> along_basic(
    const Wireframe& wire, std::map<int, Eigen::Vector3d> of_nodes) {
  for (const auto& [node, axes] : wire.axes) {
    const auto found = of_nodes.find(node);
    if (found != of_nodes.end()) found->second = axes * found->second;
  }
  return of_nodes;
}

bool pose_key(Pose& pose, Key key) {
  if (key == U'<' || key == U',') {
    pose.azimuth_deg -= 15.0;
  } else if (key == U'>' || key == U'.') {
    pose.azimuth_deg += 15.0;
  } else if (key == U'(') {
    pose.elevation_deg = std::max(pose.elevation_deg - 15.0, -90.0);
  } else if (key == U')') {
    pose.elevation_deg = std::min(pose.elevation_deg + 15.0, 90.0);
  } else if (key == U'{') {
    pose.zoom = std::max(pose.zoom / 1.25, 0.2);
  } else if (key == U'}') {
    pose.zoom = std::min(pose.zoom * 1.25, 20.0);
  } else {
    return false;
  }
  return true;
}

void draw_wireframe(Screen& screen,
                    const Rect& rect,
                    const Wireframe& wire,
                    const Scene& scene,
                    const Pose& pose) {
  if (rect.empty() || wire.points.cols() == 0) return;
  Dots dots(rect.width, rect.height, screen);
  const Projection view = fit(wire, dots, pose);
  if (screen.drawings() != nullptr)
    keep_drawing(screen, seen(wire, scene, view));
  const std::vector<Layer> layers =
      layers_of(wire, scene, legible_lines(wire, view, dots));
  for (const Layer& layer : layers) {
    draw_lines(dots, view, layer.points, layer.lines, layer.pen);
  }
  draw_feet(dots, view, layers.back());
  dots.draw(screen, rect.x, rect.y);
  draw_marks(screen, rect, view, dots, wire, scene);
}

}  // namespace tapfit::tui
