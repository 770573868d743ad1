#include "tui/widgets/wireframe.hpp"

#include "tui/screen/dots.hpp"
#include "tui/screen/text.hpp"
#include "updating/structure/elements/solid_shapes.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace tapfit::tui {
namespace {

constexpr std::size_t most_edges = 3000;

constexpr int line_element = 1000;  // told apart from shared shell edges

struct EdgeCollector {
  const Wireframe& wire;
  std::map<Edge, int> uses;

  void add(int a, int b, int weight) {
    const auto i = wire.index.find(a);
    const auto j = wire.index.find(b);
    if (i == wire.index.end() || j == wire.index.end()) return;
    if (i->second == j->second) return;
    uses[{std::min(i->second, j->second), std::max(i->second, j->second)}] +=
        weight;
  }
};

/// A line between grids that given matrices couple; none where (as in condensed
/// models) nearly each is coupled to all.
void add_couplings(const structure::Deck& deck, EdgeCollector& edges) {
  constexpr std::size_t most_neighbours = 13;  // half of a solid's 26
  std::set<Edge> couplings;
  const Eigen::SparseMatrix<double>& K = deck.given->K;
  for (Eigen::Index c = 0; c < K.outerSize(); ++c) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, c); it; ++it) {
      const auto row = static_cast<int>(it.row() / 6);
      const auto column = static_cast<int>(c / 6);
      if (row < column) couplings.insert({row, column});
    }
  }
  if (couplings.size() > most_neighbours * deck.grids.size()) return;
  for (const auto& [a, b] : couplings) {
    edges.add(deck.grids[static_cast<std::size_t>(a)].id,
              deck.grids[static_cast<std::size_t>(b)].id,
              line_element);
  }
}

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

Projection fit(const Wireframe& wire,
               const Dots& dots,
               const Pose& pose,
               bool ascii) {
  Projection view;
  view.axes = eye_axes(pose);
  const Eigen::Vector3d lo = wire.points.rowwise().minCoeff();
  const Eigen::Vector3d hi = wire.points.rowwise().maxCoeff();
  view.centre = 0.5 * (lo + hi);
  const Eigen::Matrix3Xd seen =
      view.axes * (wire.points.colwise() - view.centre);
  const double half_width = seen.row(0).cwiseAbs().maxCoeff();
  const double half_height = seen.row(1).cwiseAbs().maxCoeff();
  // Braille dots are about square; ASCII cells twice as tall as wide.
  view.stretch = ascii ? 2.0 : 1.0;
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

/// Shells as indices of their grids.
std::vector<std::vector<int>> faces_of(const structure::Deck& deck,
                                       const Wireframe& wire) {
  std::vector<std::vector<int>> faces;
  for (const structure::Shell& shell : deck.shells) {
    faces.emplace_back();
    for (const int grid : shell.grids) {
      const auto found = wire.index.find(grid);
      if (found != wire.index.end()) faces.back().push_back(found->second);
    }
  }
  return faces;
}

/// Lines of which neighbours are far enough apart to be told apart.
std::vector<Edge> legible_lines(const Wireframe& wire,
                                const Projection& view,
                                bool ascii) {
  double length = 0.0;
  for (const Edge& edge : wire.lines) {
    length += (view(wire.points.col(edge[0])) - view(wire.points.col(edge[1])))
                  .norm();
  }
  length /= std::max<double>(static_cast<double>(wire.lines.size()), 1.0);
  const double least = ascii ? 2.5 : 4.0;  // a cell in between, about
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

void draw_stems(Dots& dots,
                const Projection& view,
                const Wireframe& wire,
                const Scene& scene,
                double factor) {
  const Pen pen{Colour::Orange, Pattern::Solid, '*', false};
  for (const auto& [node, stem] : scene.stems) {
    const auto found = wire.index.find(node);
    if (found == wire.index.end()) continue;
    const Eigen::Vector3d foot = wire.points.col(found->second);
    const Eigen::Vector3d tip = foot + factor * stem;
    const Eigen::Vector2d a = view(foot);
    const Eigen::Vector2d b = view(tip);
    dots.line(a.x(), a.y(), b.x(), b.y(), pen);
    // A foot to stand on, so that a short stem is seen as well.
    dots.set(static_cast<int>(std::lround(a.x())) - 1,
             static_cast<int>(std::lround(a.y())),
             pen);
    dots.set(static_cast<int>(std::lround(a.x())) + 1,
             static_cast<int>(std::lround(a.y())),
             pen);
  }
}

void draw_marks(Screen& screen,
                const Rect& rect,
                const Projection& view,
                const Wireframe& wire,
                const Scene& scene) {
  const int per_x = screen.ascii() ? 1 : 2;
  const int per_y = screen.ascii() ? 1 : 4;
  for (const Mark& mark : scene.marks) {
    const auto found = wire.index.find(mark.node);
    if (found == wire.index.end()) continue;
    const Eigen::Vector2d at = view(wire.points.col(found->second));
    if (!at.allFinite() || at.cwiseAbs().maxCoeff() > 1e6) continue;
    const int x = rect.x + static_cast<int>(std::floor(at.x() / per_x));
    const int y = rect.y + static_cast<int>(std::floor(at.y() / per_y));
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

std::map<int, Eigen::Vector3d> along_basic(
    const Wireframe& wire, std::map<int, Eigen::Vector3d> of_nodes) {
  for (const auto& [node, axes] : wire.axes) {
    const auto found = of_nodes.find(node);
    if (found != of_nodes.end()) found->second = axes * found->second;
  }
  return of_nodes;
}

Wireframe wireframe(const structure::Deck& deck) {
  Wireframe wire;
  wire.points.resize(3, static_cast<Eigen::Index>(deck.grids.size()));
  for (std::size_t i = 0; i < deck.grids.size(); ++i) {
    wire.points.col(static_cast<Eigen::Index>(i)) = deck.grids[i].position;
    wire.index[deck.grids[i].id] = static_cast<int>(i);
  }
  for (const structure::MeasuringPoint& point : deck.measuring) {
    wire.axes[point.grid] = point.axes;
  }
  EdgeCollector edges{wire, {}};
  for (const structure::Shell& shell : deck.shells) {
    for (std::size_t i = 0; i < shell.grids.size(); ++i) {
      edges.add(shell.grids[i], shell.grids[(i + 1) % shell.grids.size()], 1);
    }
  }
  for (const structure::Solid& solid : deck.solids) {
    for (const auto& [a, b] : structure::solid_edges(solid.grids.size())) {
      edges.add(solid.grids[static_cast<std::size_t>(a)],
                solid.grids[static_cast<std::size_t>(b)],
                1);
    }
  }
  for (const auto& bar : deck.bars) {
    edges.add(bar.grids[0], bar.grids[1], line_element);
  }
  for (const auto& rod : deck.rods) {
    edges.add(rod.grids[0], rod.grids[1], line_element);
  }
  for (const auto& rigid : deck.rigids) {
    for (const auto& follower : rigid.dependents) {
      edges.add(rigid.independent, follower.grid, line_element);
    }
  }
  for (const auto& line : deck.plot_lines) {
    edges.add(line[0], line[1], line_element);
  }
  if (deck.given) add_couplings(deck, edges);
  const bool outline = edges.uses.size() > most_edges;
  const std::map<Edge, MeshEdge> mesh = mesh_edges(faces_of(deck, wire));
  for (const auto& [edge, uses] : edges.uses) {
    if (outline && uses != 1 && uses < line_element) continue;
    const auto at = mesh.find(edge);
    const bool shell = uses < line_element && at != mesh.end();
    wire.lines.push_back(edge);
    wire.ranks.push_back(shell ? at->second : MeshEdge{0, true});
  }
  return wire;
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
  Dots dots(rect.width, rect.height, screen.ascii());
  const Projection view = fit(wire, dots, pose, screen.ascii());
  const double factor = shape_factor(wire, scene);
  const std::vector<Edge> lines = legible_lines(wire, view, screen.ascii());
  const bool shaped = scene.shape.cols() == wire.points.cols();
  draw_lines(dots,
             view,
             wire.points,
             shaped ? outline_of(wire, lines) : lines,
             {Colour::Grey, Pattern::Solid, '.', false});
  if (!scene.highlighted.empty()) {
    std::set<int> wanted;
    for (const int node : scene.highlighted) {
      const auto found = wire.index.find(node);
      if (found != wire.index.end()) wanted.insert(found->second);
    }
    std::vector<Edge> places;
    for (const Edge& edge : wire.lines) {
      if (wanted.contains(edge[0]) && wanted.contains(edge[1])) {
        places.push_back(edge);
      }
    }
    draw_lines(
        dots, view, wire.points, places, {Colour::Orange, Pattern::Solid, '#'});
  }
  if (shaped) {
    const Eigen::Matrix3Xd moved = wire.points + factor * scene.shape;
    draw_lines(dots, view, moved, lines, {Colour::Blue, Pattern::Solid, '+'});
  }
  draw_stems(dots, view, wire, scene, factor);
  dots.draw(screen, rect.x, rect.y);
  draw_marks(screen, rect, view, wire, scene);
}

}  // namespace tapfit::tui
