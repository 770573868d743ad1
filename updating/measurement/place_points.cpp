#include "updating/measurement/place_points.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/measurement/lay_over.hpp"
#include "updating/places/point_on_mesh.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::updating {
namespace {

using acquisition::TestPoint;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using structure::Deck;

// A point in the model's basic axes, on what carries it.
struct Placed {
  Vector3d at;  // where it senses
  Matrix3d axes;
  PointOnMesh on;
};

// How far a model's parts are from each other without elements between them.
double extent_of(const Deck& deck) {
  Eigen::AlignedBox3d box;
  for (const structure::Grid& grid : deck.grids) {
    if (!grid.scalar) box.extend(grid.position);
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

// With the block or stand-off that it is fixed on.
constexpr double highest_sensor_m = 0.05;

PointOnMesh carrier_of(const TestPoint& point,
                       const Vector3d& at,
                       const MeshSurface& surface,
                       const Deck& deck) {
  if (point.node != 0) {
    if (deck.has_grid(point.node)) return surface.at_grid(point.node);
    throw InputError(
        fmt::format("the model has no grid {}", point.node),
        point.place,
        fmt::format("use a grid id of {}", deck.path.filename().string()));
  }
  const auto found = surface.nearest(at);
  const bool grid_alone =
      found && found->part.kind == MeshPart::Kind::Grid && found->size == 0.0;
  // On a fine mesh a sensor stands higher than an element is wide.
  const double high = std::min(highest_sensor_m, 0.1 * extent_of(deck));
  const double reach = grid_alone ? 1e-6 * extent_of(deck)
                       : found    ? std::max(found->size, high)
                                  : 0.0;
  if (found && found->off <= reach) return *found;
  const std::string there =
      fmt::format("{:.6g}, {:.6g}, {:.6g} m", at.x(), at.y(), at.z());
  if (!found || grid_alone) {
    throw InputError(
        fmt::format("no element of the model carries the point at {}", there),
        point.place,
        "name a grid of the model in \"node\": there are no shells, solids, "
        "bars or rods between the grids");
  }
  throw InputError(
      fmt::format("the point at {} is {:.3g} m from the nearest element ({}), "
                  "farther than that is wide or a sensor high ({:.3g} m)",
                  there,
                  found->off,
                  describe(found->part),
                  reach),
      point.place,
      "correct the coordinates: they count in the model's basic axes and unit "
      "of length; a sensor on a stand-off needs the stand-off in the model");
}

Vector3d lifted(const TestPoint& point,
                const Vector3d& at,
                const PointOnMesh& on) {
  if (point.height_m == 0.0) return at;
  if (!on.normal.isZero(0.0)) return at + point.height_m * on.normal;
  throw InputError(
      fmt::format("the surface at {} has no one normal that a height of {} m "
                  "could count along",
                  describe(on.part),
                  point.height_m),
      point.place,
      "leave height_m out and give in \"at\" the coordinates of the sensing "
      "element itself, above the surface");
}

Matrix3d axes_of_point(const TestPoint& point,
                       const Vector3d& at,
                       const Deck& deck) {
  if (point.system == 0) return point.axes;
  const auto system = deck.systems.find(point.system);
  if (system != deck.systems.end()) {
    return system->second.directions(at) * point.axes;
  }
  throw InputError(
      fmt::format("the model has no coordinate system {}", point.system),
      point.place,
      "name a CORD1R, CORD2R, CORD2C, ... card of the deck, or give the "
      "direction as a vector");
}

Placed placed(const TestPoint& point,
              const MeshSurface& surface,
              const Deck& deck) {
  Vector3d at = point.at.value_or(Vector3d::Zero());
  Matrix3d turn = Matrix3d::Identity();
  if (point.node != 0 && deck.has_grid(point.node)) {
    at = deck.grids[deck.grid_index(point.node)].position;
  } else if (point.of_node != 0) {
    at = deck.laid_over->rotation * at + deck.laid_over->translation;
    turn = deck.laid_over->rotation;
  }
  const PointOnMesh on = carrier_of(point, at, surface, deck);
  const Matrix3d axes = axes_of_point(point, at, deck);
  return {lifted(point, at, on),
          point.system == 0 ? Matrix3d(turn * axes) : axes,
          on};
}

// Shares are along basic axes, terms along the grids' own.
std::vector<structure::RelationTerm> terms_of(
    const std::vector<MotionShare>& shares, const Deck& deck) {
  constexpr double rounding = 1e-14;  // at a corner the others' shares
  std::vector<structure::RelationTerm> terms;
  for (const MotionShare& share : shares) {
    const structure::Grid& grid = deck.grids[deck.grid_index(share.node)];
    const int kind = share.component > 3 ? 3 : 0;
    for (int own = 0; own < 3; ++own) {
      const double factor =
          share.weight * grid.axes((share.component - 1) % 3, own);
      if (std::abs(factor) <= rounding) continue;
      terms.push_back({share.node, own + 1 + kind, factor});
    }
  }
  return terms;
}

void add_to_deck(const TestPoint& point, const Placed& at, Deck& deck) {
  const int id = -point.label;
  for (int component = 1; component <= 6; ++component) {
    const Vector3d axis = at.axes.col((component - 1) % 3);
    const std::vector<MotionShare> shares =
        component <= 3 ? motion_at(at.on, deck, at.at, axis)
                       : turning_at(at.on, deck, axis);
    deck.relations.push_back(
        {id, component, terms_of(shares, deck), point.place});
  }
  structure::MeasuringPoint measuring;
  measuring.grid = id;
  measuring.axes = at.axes;
  measuring.foot = at.on.foot;
  measuring.on = describe(at.on.part);
  measuring.off = at.on.off;
  measuring.to_grid = std::numeric_limits<double>::max();
  for (const structure::Grid& grid : deck.grids) {
    if (grid.id < 0 || grid.scalar) continue;
    const double far = (grid.position - at.at).norm();
    if (far >= measuring.to_grid) continue;
    measuring.to_grid = far;
    measuring.nearest = grid.id;
  }
  deck.measuring.push_back(measuring);
}

structure::SparseMatrix behind(const structure::SparseMatrix& A,
                               Eigen::Index rows) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index k = 0; k < A.outerSize(); ++k) {
    for (structure::SparseMatrix::InnerIterator it(A, k); it; ++it) {
      entries.emplace_back(rows + it.row(), rows + it.col(), it.value());
    }
  }
  structure::SparseMatrix wider(rows + A.rows(), rows + A.cols());
  wider.setFromTriplets(entries.begin(), entries.end());
  return wider;
}

// In front, by ascending ids, so that grids are still found by halving.
void add_grids(std::vector<structure::Grid> grids, Deck& deck) {
  std::ranges::sort(grids, {}, &structure::Grid::id);
  deck.grids.insert(deck.grids.begin(), grids.begin(), grids.end());
  if (!deck.given) return;
  const auto rows = static_cast<Eigen::Index>(6 * grids.size());
  deck.given =
      std::make_shared<const structure::GivenMatrices>(structure::GivenMatrices{
          behind(deck.given->K, rows), behind(deck.given->M, rows)});
}

// Of the test's geometry, those that the points are at.
std::set<int> nodes_at(const std::vector<TestPoint>& points,
                       const std::set<int>& used) {
  std::set<int> nodes;
  for (const TestPoint& point : points) {
    if (used.contains(point.label) && point.of_node != 0) {
      nodes.insert(point.of_node);
    }
  }
  return nodes;
}

}  // namespace

void place_points(const acquisition::TestBundle& bundle,
                  const std::set<int>& used,
                  Deck& deck) {
  if (used.empty()) return;
  const MeshSurface surface(deck);
  const std::set<int> nodes = nodes_at(bundle.points, used);
  if (!nodes.empty()) {
    deck.laid_over = lay_over(*bundle.geometry, nodes, deck, surface);
  }
  std::vector<structure::Grid> grids;
  for (const TestPoint& point : bundle.points) {
    if (!used.contains(point.label)) continue;
    const Placed at = placed(point, surface, deck);
    add_to_deck(point, at, deck);
    grids.push_back({-point.label, at.at});
  }
  add_grids(std::move(grids), deck);
}

Vector3d direction_of(const Deck& deck, const Dof& dof) {
  const auto axis = static_cast<Eigen::Index>((dof.component - 1) % 3);
  const auto point = std::ranges::find(
      deck.measuring, dof.node, &structure::MeasuringPoint::grid);
  const Vector3d along = point == deck.measuring.end()
                             ? Vector3d::Unit(axis)
                             : Vector3d(point->axes.col(axis));
  return dof.sign * along;
}

}  // namespace tapfit::updating
