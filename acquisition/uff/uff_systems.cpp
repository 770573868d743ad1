#include "acquisition/uff/uff_systems.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/named_axes.hpp"
#include "acquisition/uff/uff_lines.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <set>

namespace tapfit::acquisition {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int first_own_label = 100'000'000;

CoordinateKind kind_of(int kind, const std::string& place) {
  if (kind >= 0 && kind <= 2) return static_cast<CoordinateKind>(kind);
  throw InputError(
      fmt::format("coordinate system type {} is none of 0, 1, 2", kind),
      place,
      "export rectangular, cylindrical or spherical systems");
}

std::string place_of(const UffDataset& dataset, int label) {
  return fmt::format("{}: coordinate system {} of dataset {}",
                     dataset.place,
                     label,
                     dataset.type);
}

void add_systems_18(const UffDataset& dataset, UffGeometry& geometry) {
  UffLines lines(dataset);
  while (!lines.only_blanks_left()) {
    const std::vector<int> head = lines.integers(3);
    (void)lines.text();
    const std::vector<double> v = lines.many(13, 9);
    UffSystem system;
    system.place = place_of(dataset, head[0]);
    system.kind = kind_of(head[1], system.place);
    system.reference = head[2];
    system.points = Eigen::Map<const Matrix3d>(v.data());
    geometry.systems[head[0]] = system;
  }
}

// Unit vectors to as many digits as anybody writes.
void check_axes(const Matrix3d& axes, const std::string& place) {
  constexpr double rounding = 1e-3;
  const bool unit = (axes.transpose() * axes).isIdentity(rounding);
  if (unit && axes.determinant() > 0.0) return;
  throw InputError("the rows of its matrix are no right-handed unit vectors",
                   place,
                   "export the system anew; its rows 1 to 3 are its axes x, y, "
                   "z, row 4 its origin");
}

void add_systems_2420(const UffDataset& dataset, UffGeometry& geometry) {
  UffLines lines(dataset);
  if (lines.only_blanks_left()) return;
  (void)lines.integers(1);
  (void)lines.text();
  while (!lines.only_blanks_left()) {
    const std::vector<int> head = lines.integers(2);
    (void)lines.text();
    Eigen::Matrix<double, 4, 3> rows;
    for (Eigen::Index i = 0; i < 4; ++i) {
      const std::vector<double> v = lines.numbers(25, 3);
      rows.row(i) << v[0], v[1], v[2];
    }
    UffSystem system;
    system.place = place_of(dataset, head[0]);
    system.kind = kind_of(head[1], system.place);
    const Matrix3d axes = rows.topRows<3>().transpose();
    check_axes(axes, system.place);
    const Vector3d origin = rows.row(3).transpose();
    system.points << origin, origin + axes.col(0), origin + axes.col(2);
    geometry.systems[head[0]] = system;
  }
}

CoordinateSystem resolved(const UffGeometry& geometry,
                          int label,
                          const std::string& user,
                          std::set<int>& open) {
  if (label == 0) return {};
  const auto found = geometry.systems.find(label);
  if (found == geometry.systems.end()) {
    if (label == 1) return {};
    throw InputError(
        fmt::format("coordinate system {} is not in the file", label),
        user,
        "export the coordinate systems too (dataset 2420 or 18), or all nodes "
        "in global axes");
  }
  const UffSystem& system = found->second;
  if (!open.insert(label).second) {
    throw InputError("it counts in itself, round a ring of references",
                     system.place,
                     "let one of the systems count in the global one (0)");
  }
  const CoordinateSystem reference =
      resolved(geometry, system.reference, system.place, open);
  const Vector3d origin = reference.place(system.points.col(0));
  const auto axes =
      axes_through(0,
                   reference.place(system.points.col(1)) - origin,
                   reference.place(system.points.col(2)) - origin);
  if (!axes) {
    throw InputError("its three points lie on a line",
                     system.place,
                     "give a point of its x-z plane that is off the x axis");
  }
  return {origin, *axes, system.kind};
}

std::string user_of(int node, const UffNodeSystems& systems) {
  return fmt::format("{}: node {}", systems.place, node);
}

}  // namespace

void add_systems(const UffDataset& dataset, UffGeometry& geometry) {
  if (dataset.type == 18) add_systems_18(dataset, geometry);
  if (dataset.type == 2420) add_systems_2420(dataset, geometry);
}

CoordinateSystem system_of(const UffGeometry& geometry,
                           int label,
                           const std::string& user) {
  std::set<int> open;
  return resolved(geometry, label, user, open);
}

Vector3d position_of(const UffGeometry& geometry, int node) {
  const Vector3d& written = geometry.nodes.at(node);
  const auto systems = geometry.node_systems.find(node);
  if (systems == geometry.node_systems.end()) return written;
  return system_of(geometry,
                   systems->second.definition,
                   user_of(node, systems->second))
      .place(written);
}

Matrix3d directions_at(const UffGeometry& geometry, int node) {
  const auto systems = geometry.node_systems.find(node);
  if (systems == geometry.node_systems.end()) return Matrix3d::Identity();
  return system_of(geometry,
                   systems->second.displacement,
                   user_of(node, systems->second))
      .directions(position_of(geometry, node));
}

std::optional<Matrix3d> skew_axes(const UffGeometry& geometry, int node) {
  const Matrix3d axes = directions_at(geometry, node);
  const Matrix3d named = named_like_basic(axes);
  constexpr double rounding = 1e-6;
  if (named.isIdentity(rounding)) return std::nullopt;
  return named;
}

Dof turned(const UffGeometry& geometry, const Dof& dof) {
  const Matrix3d axes = directions_at(geometry, dof.node);
  const Matrix3d named = named_like_basic(axes);
  const int kind = dof.component > 3 ? 3 : 0;
  const Vector3d direction = dof.sign * axes.col((dof.component - 1) % 3);
  const auto along = along_one_of(named, direction);
  Dof result = dof;
  if (along) {
    result.component = along->component + kind;
    result.sign = along->sign;
  }
  const int node = node_of_uff_label(dof.node);
  result.node = node > 0 && skew_axes(geometry, dof.node) ? -node : node;
  return result;
}

UffGeometry read_geometry(const std::vector<UffDataset>& file) {
  UffGeometry geometry;
  for (const UffDataset& dataset : file) {
    if (dataset.type == 15 || dataset.type == 2411 || dataset.type == 18 ||
        dataset.type == 2420) {
      add_geometry(dataset, geometry);
      add_systems(dataset, geometry);
    }
  }
  return geometry;
}

int uff_label(int node) { return node < 0 ? first_own_label - node : node; }

int node_of_uff_label(int label) {
  return label > first_own_label ? first_own_label - label : label;
}

}  // namespace tapfit::acquisition
