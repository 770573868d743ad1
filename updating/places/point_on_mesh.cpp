#include "updating/places/point_on_mesh.hpp"

#include "updating/structure/elements/solid_shapes.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// Of an element's size: what rounding moves a point by.
constexpr double same_place = 1e-6;

const std::vector<std::vector<std::size_t>>& faces_of(std::size_t corners) {
  using Faces = std::vector<std::vector<std::size_t>>;
  static const Faces hexahedron{{0, 1, 2, 3},
                                {4, 5, 6, 7},
                                {0, 1, 5, 4},
                                {1, 2, 6, 5},
                                {2, 3, 7, 6},
                                {3, 0, 4, 7}};
  static const Faces wedge{
      {0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  static const Faces pyramid{
      {0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  static const Faces tetrahedron{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  if (corners == 8) return hexahedron;
  if (corners == 6) return wedge;
  return corners == 5 ? pyramid : tetrahedron;
}

Vector3d mean_of(const std::vector<Vector3d>& x) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& p : x) sum += p;
  return sum / static_cast<double>(x.size());
}

// The grid in the middle of an edge of a solid, 0 where there is none.
int mid_between(const structure::Solid& solid, int a, int b) {
  const auto& edges = structure::solid_edges(solid.grids.size());
  for (std::size_t k = 0; k < edges.size() && k < solid.mids.size(); ++k) {
    const int first = solid.grids[static_cast<std::size_t>(edges[k][0])];
    const int second = solid.grids[static_cast<std::size_t>(edges[k][1])];
    if ((first == a && second == b) || (first == b && second == a)) {
      return solid.mids[k];
    }
  }
  return 0;
}

MeshPart face_of(const Deck& deck,
                 const structure::Solid& solid,
                 const std::vector<std::size_t>& corners) {
  MeshPart face{MeshPart::Kind::Face, solid.id, {}, {}};
  for (const std::size_t c : corners) face.grids.push_back(solid.grids[c]);
  const std::vector<Vector3d> x = deck.positions(face.grids);
  const Vector3d outward = mean_of(x) - mean_of(deck.positions(solid.grids));
  if (normal_of(x).dot(outward) < 0.0) {
    std::reverse(face.grids.begin(), face.grids.end());
  }
  for (std::size_t k = 0; k < face.grids.size() && !solid.mids.empty(); ++k) {
    face.mids.push_back(mid_between(
        solid, face.grids[k], face.grids[(k + 1) % face.grids.size()]));
  }
  return face;
}

// Faces that one solid has alone.
std::vector<MeshPart> outer_faces(const Deck& deck) {
  std::map<std::vector<int>, std::pair<int, MeshPart>> found;
  for (const structure::Solid& solid : deck.solids) {
    for (const auto& corners : faces_of(solid.grids.size())) {
      MeshPart face = face_of(deck, solid, corners);
      std::vector<int> key = face.grids;
      std::ranges::sort(key);
      auto& [count, part] = found[key];
      if (++count == 1) part = std::move(face);
    }
  }
  std::vector<MeshPart> faces;
  for (auto& [key, entry] : found) {
    if (entry.first == 1) faces.push_back(std::move(entry.second));
  }
  return faces;
}

std::vector<MeshPart> parts_of(const Deck& deck) {
  std::vector<MeshPart> parts;
  for (const structure::Shell& e : deck.shells) {
    parts.push_back({MeshPart::Kind::Shell, e.id, e.grids, e.mids});
  }
  for (MeshPart& face : outer_faces(deck)) parts.push_back(std::move(face));
  for (const structure::Bar& e : deck.bars) {
    parts.push_back(
        {MeshPart::Kind::Bar, e.id, {e.grids.begin(), e.grids.end()}, {}});
  }
  for (const structure::Rod& e : deck.rods) {
    parts.push_back(
        {MeshPart::Kind::Rod, e.id, {e.grids.begin(), e.grids.end()}, {}});
  }
  return parts;
}

double side_of(const std::vector<Vector3d>& x) {
  if (x.size() == 2) return (x[1] - x[0]).norm();
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum += (x[(k + 1) % x.size()] - x[k]).norm();
  }
  return sum / static_cast<double>(x.size());
}

// Where one of its grids is on a part with straight sides; empty for a grid
// that it does not have.
std::optional<Vector3d> straight_place(const MeshPart& part,
                                       const std::vector<Vector3d>& x,
                                       int grid) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (part.grids[k] == grid) return x[k];
    if (k < part.mids.size() && part.mids[k] == grid) {
      return 0.5 * (x[k] + x[(k + 1) % x.size()]);
    }
  }
  return std::nullopt;
}

// The nearest grid of the deck; not those of the test.
std::optional<std::pair<int, double>> nearest_grid(const Deck& deck,
                                                   const Vector3d& at) {
  std::optional<std::pair<int, double>> found;
  for (const structure::Grid& grid : deck.grids) {
    if (grid.id < 0 || grid.scalar) continue;
    const double off = (grid.position - at).norm();
    if (!found || off < found->second) found = {grid.id, off};
  }
  return found;
}

}  // namespace

MeshSurface::MeshSurface(const Deck& deck) : deck_(&deck) {
  for (MeshPart& part : parts_of(deck)) {
    Placed placed{std::move(part), {}, {}, 0.0};
    placed.x = deck.positions(placed.part.grids);
    placed.middle = mean_of(placed.x);
    for (const Vector3d& x : placed.x) {
      placed.reach = std::max(placed.reach, (x - placed.middle).norm());
    }
    parts_.push_back(std::move(placed));
  }
}

// Of the parts that hold the foot, where a grid is given of those at it.
Vector3d MeshSurface::normal_at(const Vector3d& foot,
                                double tolerance,
                                int grid) const {
  constexpr double folded = 0.9;  // of unit normals that all agree
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (const Placed& placed : parts_) {
    const bool surface = placed.part.kind == MeshPart::Kind::Shell ||
                         placed.part.kind == MeshPart::Kind::Face;
    if (!surface) continue;
    std::optional<Vector3d> there;
    if (grid != 0) {
      there = straight_place(placed.part, placed.x, grid);
    } else if ((foot - placed.middle).norm() <= placed.reach + tolerance) {
      there = nearest_in(placed.x, foot);
      if ((*there - foot).norm() > tolerance) there.reset();
    }
    const auto shapes = there ? shapes_at(placed.x, *there) : std::nullopt;
    if (!shapes) continue;
    sum += shapes->normal;
    ++count;
  }
  if (count == 0 || sum.norm() < folded * count) return Vector3d::Zero();
  return sum.normalized();
}

std::optional<PointOnMesh> MeshSurface::nearest(const Vector3d& at) const {
  const Placed* best = nullptr;
  PointOnMesh found;
  found.off = std::numeric_limits<double>::max();
  for (const Placed& placed : parts_) {
    if ((at - placed.middle).norm() - placed.reach >= found.off) continue;
    const Vector3d foot = nearest_in(placed.x, at);
    const double off = (at - foot).norm();
    // The first of those that touch there.
    if (off >= found.off - same_place * placed.reach) continue;
    best = &placed;
    found.foot = foot;
    found.off = off;
  }
  const auto grid = nearest_grid(*deck_, at);
  if (best == nullptr) {
    if (!grid) return std::nullopt;
    return PointOnMesh{{MeshPart::Kind::Grid, grid->first, {grid->first}, {}},
                       deck_->grid(grid->first).position,
                       grid->second};
  }
  found.size = side_of(best->x);
  const double rounding = same_place * found.size;
  if (grid && grid->second <= rounding && found.off > rounding) {
    return at_grid(grid->first);
  }
  found.part = best->part;
  found.straight_foot = found.foot;
  found.normal = normal_at(found.foot, rounding, 0);
  return found;
}

PointOnMesh MeshSurface::at_grid(int grid) const {
  PointOnMesh found;
  found.foot = deck_->grid(grid).position;
  found.part = {MeshPart::Kind::Grid, grid, {grid}, {}};
  const auto holds = [grid](const Placed& placed) {
    return straight_place(placed.part, placed.x, grid).has_value();
  };
  const auto placed = std::ranges::find_if(parts_, holds);
  if (placed == parts_.end()) return found;
  found.part = placed->part;
  found.straight_foot = *straight_place(placed->part, placed->x, grid);
  found.size = side_of(placed->x);
  found.normal = normal_at(found.foot, same_place * found.size, grid);
  return found;
}

namespace {

// A grid's shares of a value, and their gradients along the element.
struct Share {
  int grid = 0;
  double value = 0.0;
  Vector3d gradient = Vector3d::Zero();
};

// The middle of a side takes from its ends: 4 N_i N_j on a triangle, on a
// quadrilateral that over N_i + N_j, (1 - xi^2) (1 - eta) / 2.
std::vector<Share> with_mids(const MeshPart& part, const Shapes& shapes) {
  std::vector<Share> shares;
  const std::size_t n = part.grids.size();
  for (std::size_t k = 0; k < n; ++k) {
    shares.push_back({part.grids[k], shapes.linear[k], shapes.gradient[k]});
  }
  for (std::size_t k = 0; k < part.mids.size(); ++k) {
    if (part.mids[k] == 0) continue;
    const std::size_t j = (k + 1) % n;
    const double a = shapes.linear[k];
    const double b = shapes.linear[j];
    const Vector3d& da = shapes.gradient[k];
    const Vector3d& db = shapes.gradient[j];
    Share mid{part.mids[k], 4.0 * a * b, 4.0 * (a * db + b * da)};
    if (n == 4) {
      const double sum = a + b;
      if (sum <= same_place) {
        mid.value = 0.0;
        mid.gradient.setZero();
      } else {
        mid.value /= sum;
        mid.gradient = (mid.gradient - mid.value * (da + db)) / sum;
      }
    }
    for (const std::size_t end : {k, j}) {
      shares[end].value -= 0.5 * mid.value;
      shares[end].gradient -= 0.5 * mid.gradient;
    }
    shares.push_back(mid);
  }
  return shares;
}

// A point of a part taken apart, for motions along several axes.
class Followed {
 public:
  Followed(const PointOnMesh& point, const Deck& deck)
      : part_(&point.part), x_(deck.positions(point.part.grids)) {
    if (part_->kind == MeshPart::Kind::Grid) {
      shares_ = {{part_->grids.front(), 1.0}};
      return;
    }
    shapes_ = shapes_at(x_, point.straight_foot);
    if (!shapes_) return;
    shares_ = with_mids(*part_, *shapes_);
  }

  // u . axis at the foot.
  void add_motion(const Vector3d& axis,
                  std::map<int, CornerMotion>& sum) const {
    const bool bends = (part_->kind == MeshPart::Kind::Shell ||
                        part_->kind == MeshPart::Kind::Bar) &&
                       part_->mids.empty();
    if (bends && shapes_) {
      const std::vector<CornerMotion> corners =
          motion_along(x_, *shapes_, axis);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        sum[part_->grids[k]].moved += corners[k].moved;
        sum[part_->grids[k]].turned += corners[k].turned;
      }
      return;
    }
    for (const Share& share : shares_) {
      sum[share.grid].moved += share.value * axis;
    }
  }

  // theta . axis.
  void add_turning(const Vector3d& axis,
                   std::map<int, CornerMotion>& sum) const {
    for (const Share& share : shares_) {
      CornerMotion& motion = sum[share.grid];
      if (part_->kind == MeshPart::Kind::Face) {
        const Vector3d& n = shapes_->normal;
        motion.moved += share.gradient.cross(n).dot(axis) * n +
                        0.5 * n.dot(axis) * n.cross(share.gradient);
      } else if (part_->kind == MeshPart::Kind::Rod) {
        const Vector3d t = (x_[1] - x_[0]).normalized();
        motion.moved += share.gradient.dot(t) * axis.cross(t);
      } else {
        motion.turned += share.value * axis;
      }
    }
  }

 private:
  const MeshPart* part_;
  std::vector<Vector3d> x_;
  std::optional<Shapes> shapes_;
  std::vector<Share> shares_;
};

std::vector<MotionShare> listed(const std::map<int, CornerMotion>& sum) {
  std::vector<MotionShare> shares;
  for (const auto& [grid, motion] : sum) add_shares(grid, motion, shares);
  return shares;
}

}  // namespace

std::vector<MotionShare> motion_at(const PointOnMesh& point,
                                   const Deck& deck,
                                   const Vector3d& at,
                                   const Vector3d& axis) {
  const Followed followed(point, deck);
  std::map<int, CornerMotion> sum;
  followed.add_motion(axis, sum);
  const Vector3d arm = at - point.foot;
  if (!arm.isZero(0.0)) followed.add_turning(arm.cross(axis), sum);
  return listed(sum);
}

std::vector<MotionShare> turning_at(const PointOnMesh& point,
                                    const Deck& deck,
                                    const Vector3d& axis) {
  std::map<int, CornerMotion> sum;
  Followed(point, deck).add_turning(axis, sum);
  return listed(sum);
}

std::string describe(const MeshPart& part) {
  switch (part.kind) {
    case MeshPart::Kind::Grid:
      return fmt::format("grid {}", part.element);
    case MeshPart::Kind::Shell:
      return fmt::format("shell {}", part.element);
    case MeshPart::Kind::Face:
      return fmt::format("solid {}", part.element);
    case MeshPart::Kind::Bar:
      return fmt::format("bar {}", part.element);
    case MeshPart::Kind::Rod:
      break;
  }
  return fmt::format("rod {}", part.element);
}

}  // namespace tapfit::updating
