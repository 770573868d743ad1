#include "tui/document/svg_structure.hpp"

#include "tui/document/svg_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tapfit::tui {
namespace {

constexpr std::size_t most_lines = 700;
constexpr double margin = 16.0;
constexpr double letter = 6.4;  // mean width in labels [px]

/// Rows: to the right and down in the picture.
Eigen::Matrix<double, 2, 3> eye() {
  constexpr Pose pose;
  const double a = pose.azimuth_deg * std::numbers::pi / 180.0;
  const double e = pose.elevation_deg * std::numbers::pi / 180.0;
  Eigen::Matrix<double, 2, 3> rows;
  rows << std::cos(a), -std::sin(a), 0.0,  //
      -std::sin(e) * std::sin(a), -std::sin(e) * std::cos(a), -std::cos(e);
  return rows;
}

struct View {
  Eigen::Matrix2Xd at;                 ///< every point of the wire [px]
  Eigen::Matrix<double, 2, 3> scaled;  ///< displacement to pixels
  double height = 0.0;
  double size = 1.0;  ///< of the structure [m]
};

View view_of(const Wireframe& wire, double width, double tallest) {
  View view;
  view.scaled = eye();
  if (wire.points.cols() == 0) return {{}, view.scaled, 2.0 * margin, 1.0};
  const Eigen::Matrix2Xd flat = view.scaled * wire.points;
  const Eigen::Vector2d low = flat.rowwise().minCoeff();
  const Eigen::Vector2d span = flat.rowwise().maxCoeff() - low;
  view.size = std::max(
      (wire.points.rowwise().maxCoeff() - wire.points.rowwise().minCoeff())
          .norm(),
      1e-9);
  // A line seen from its end has no width.
  const double smallest = 1e-6 * view.size;
  const double scale =
      std::min((width - 2.0 * margin) / std::max(span.x(), smallest),
               (tallest - 2.0 * margin) / std::max(span.y(), smallest));
  view.height = std::max(scale * span.y() + 2.0 * margin, 60.0);
  const Eigen::Vector2d offset(
      (width - scale * span.x()) / 2.0 - scale * low.x(),
      (view.height - scale * span.y()) / 2.0 - scale * low.y());
  view.at = (scale * flat).colwise() + offset;
  view.scaled *= scale;
  return view;
}

/// Where the axes stand: in the corner farthest from the structure.
Eigen::Vector2d corner_for_axes(const View& view, double width) {
  constexpr double inset = 34.0;
  Eigen::Vector2d best(inset, view.height - inset);
  double farthest = -1.0;
  for (const double y : {view.height - inset, inset}) {
    for (const double x : {inset, width - inset}) {
      const Eigen::Vector2d corner(x, y);
      const double near =
          (view.at.colwise() - corner).colwise().norm().minCoeff();
      if (near <= farthest) continue;
      farthest = near;
      best = corner;
    }
  }
  return best;
}

/// The basic axes, as long as they are seen.
void draw_triad(SvgCanvas& canvas, const Eigen::Vector2d& origin) {
  constexpr double length = 24.0;
  constexpr const char* names[] = {"X", "Y", "Z"};
  const Eigen::Matrix<double, 2, 3> axes = length * eye();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d tip = origin + axes.col(k);
    canvas.line(origin.x(), origin.y(), tip.x(), tip.y(), {ink::black, 1.2});
    const Eigen::Vector2d at = origin + 1.35 * axes.col(k);
    canvas.text(
        at.x(), at.y() + 4.0, names[k], {.anchor = "middle", .size = 11.0});
  }
}

/// The lines of a mesh as coarse as a picture wants it.
std::vector<Edge> drawn_lines(const Wireframe& wire) {
  const bool ranked = wire.ranks.size() == wire.lines.size();
  for (int step = 1;; step *= 2) {
    std::vector<Edge> kept;
    for (std::size_t k = 0; k < wire.lines.size(); ++k) {
      if (!ranked || wire.ranks[k].outline || wire.ranks[k].depth % step == 0) {
        kept.push_back(wire.lines[k]);
      }
    }
    if (kept.size() <= most_lines || !ranked || step > 64) return kept;
  }
}

/// Lines joined end to end, each a row of points.
std::vector<std::vector<int>> chains(const std::vector<Edge>& lines) {
  std::map<int, std::set<int>> beside;
  for (const Edge& line : lines) {
    beside[line[0]].insert(line[1]);
    beside[line[1]].insert(line[0]);
  }
  std::vector<std::vector<int>> found;
  const auto walk = [&](int from) {
    std::vector<int> chain{from};
    while (!beside[from].empty()) {
      const int to = *beside[from].begin();
      beside[from].erase(to);
      beside[to].erase(from);
      chain.push_back(to);
      from = to;
    }
    if (chain.size() > 1) found.push_back(std::move(chain));
  };
  // From ends and corners first: a walk that starts there need not end midway.
  for (const bool odd : {true, false}) {
    for (auto& [point, others] : beside) {
      while (!others.empty() && (!odd || others.size() % 2 == 1)) walk(point);
    }
  }
  return found;
}

std::string lines_path(const std::vector<std::vector<int>>& all,
                       const Eigen::Matrix2Xd& at) {
  std::string d;
  for (const auto& chain : all) {
    for (std::size_t k = 0; k < chain.size(); ++k) {
      d += (k == 0   ? "M"
            : k == 1 ? "L"
                     : " ") +
           coordinate(at(0, chain[k])) + " " + coordinate(at(1, chain[k]));
    }
  }
  return d;
}

double largest(const SvgShape& shape) {
  double most = 0.0;
  if (shape.grids.cols() > 0) most = shape.grids.colwise().norm().maxCoeff();
  for (const auto& [node, u] : shape.points) most = std::max(most, u.norm());
  return most;
}

/// Dots where the measured points are when they swing out by `factor`.
std::string dots_path(const Wireframe& wire,
                      const View& view,
                      const SvgShape& shape,
                      double factor,
                      bool stems) {
  std::string d;
  for (const auto& [node, u] : shape.points) {
    const auto found = wire.index.find(node);
    if (found == wire.index.end()) continue;
    const Eigen::Vector2d rest = view.at.col(found->second);
    const Eigen::Vector2d out = rest + factor * (view.scaled * u);
    if (stems) {
      d += "M" + coordinate(rest.x()) + " " + coordinate(rest.y()) + "L" +
           coordinate(out.x()) + " " + coordinate(out.y());
    } else {
      d += "M" + coordinate(out.x()) + " " + coordinate(out.y()) + "h0";
    }
  }
  return d;
}

}  // namespace

std::string svg_structure(const Wireframe& wire, const SvgStructure& picture) {
  const View view = view_of(wire, picture.width, picture.tallest);
  SvgCanvas canvas(picture.width, view.height, picture.name);
  const std::string d = lines_path(chains(drawn_lines(wire)), view.at);
  if (!d.empty()) canvas.path(d, {ink::grey, 0.8});
  if (view.at.cols() > 0) {
    draw_triad(canvas, corner_for_axes(view, picture.width));
  }
  for (const SvgMark& mark : picture.marks) {
    const auto found = wire.index.find(mark.node);
    if (found == wire.index.end()) continue;
    const Eigen::Vector2d at = view.at.col(found->second);
    canvas.circle(at.x(), at.y(), mark.radius, mark.colour);
    if (mark.label.empty()) continue;
    // Set to the left of its point where there is no room to the right.
    const double length = letter * static_cast<double>(mark.label.size());
    const bool right = at.x() + 7.0 + length > picture.width;
    canvas.text(at.x() + (right ? -7.0 : 7.0),
                std::max(at.y() - 5.0, 12.0),
                mark.label,
                {.anchor = right ? "end" : "start",
                 .size = 11.5,
                 .colour = mark.colour});
  }
  return canvas.svg();
}

std::string svg_shape(const Wireframe& wire, const SvgShape& shape) {
  const View view = view_of(wire, shape.width, shape.tallest);
  const double most = largest(shape);
  const double factor = most > 0.0 ? view.size / 8.0 / most : 0.0;
  const double room = (factor * most * view.scaled).rowwise().norm().maxCoeff();
  // What swings out needs room above and below.
  const double above = std::min(room, shape.tallest / 3.0);
  View moved = view;
  moved.at.row(1).array() += above - margin / 2.0;
  SvgCanvas canvas(shape.width, view.height + 2.0 * above - margin, shape.name);
  const auto all = chains(drawn_lines(wire));
  canvas.path(lines_path(all, moved.at), {ink::pale, 0.8});
  if (shape.grids.cols() == moved.at.cols() && moved.at.cols() > 0) {
    const Eigen::Matrix2Xd u = factor * (moved.scaled * shape.grids);
    canvas.swinging_path(lines_path(all, moved.at + u),
                         lines_path(all, moved.at - u),
                         {ink::blue, 0.9});
  } else {
    canvas.swinging_path(dots_path(wire, moved, shape, factor, true),
                         dots_path(wire, moved, shape, -factor, true),
                         {ink::orange});
  }
  canvas.swinging_path(dots_path(wire, moved, shape, factor, false),
                       dots_path(wire, moved, shape, -factor, false),
                       {ink::orange, 5.0, {}, true});
  return canvas.svg();
}

}  // namespace tapfit::tui
