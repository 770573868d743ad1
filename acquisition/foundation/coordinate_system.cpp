#include "acquisition/foundation/coordinate_system.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace tapfit {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180.0;

// Directions r, theta, z at an angle about the third of the axes.
Matrix3d turned_about_z(const Matrix3d& axes, double angle) {
  return axes * Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

double angle_of(double y, double x) {
  return x == 0.0 && y == 0.0 ? 0.0 : std::atan2(y, x);
}

}  // namespace

Vector3d CoordinateSystem::place(const Vector3d& coordinates) const {
  Vector3d local = coordinates;
  const double r = coordinates(0);
  const double theta = coordinates(1) * degree;
  if (kind == CoordinateKind::Cylindrical) {
    local << r * std::cos(theta), r * std::sin(theta), coordinates(2);
  } else if (kind == CoordinateKind::Spherical) {
    const double phi = coordinates(2) * degree;
    local << r * std::sin(theta) * std::cos(phi),
        r * std::sin(theta) * std::sin(phi), r * std::cos(theta);
  }
  return origin + axes * local;
}

Matrix3d CoordinateSystem::directions(const Vector3d& place) const {
  if (kind == CoordinateKind::Rectangular) return axes;
  const Vector3d local = axes.transpose() * (place - origin);
  const Matrix3d cylinder =
      turned_about_z(axes, angle_of(local.y(), local.x()));
  if (kind == CoordinateKind::Cylindrical) return cylinder;
  const double theta = angle_of(local.head<2>().norm(), local.z());
  const Vector3d outward = cylinder.col(0);
  const Vector3d z = cylinder.col(2);
  Matrix3d sphere;
  sphere << std::sin(theta) * outward + std::cos(theta) * z,
      std::cos(theta) * outward - std::sin(theta) * z, cylinder.col(1);
  return sphere;
}

std::optional<Matrix3d> axes_through(int first,
                                     const Vector3d& along,
                                     const Vector3d& beside) {
  const Vector3d y = first == 0 ? Vector3d(beside.cross(along))
                                : Vector3d(along.cross(beside));
  if (!(y.norm() > 1e-10 * along.norm() * beside.norm()) || y.norm() == 0.0) {
    return std::nullopt;
  }
  Matrix3d axes;
  axes.col(1) = y.normalized();
  axes.col(first) = along.normalized();
  if (first == 0) {
    axes.col(2) = axes.col(0).cross(axes.col(1));
  } else {
    axes.col(0) = axes.col(1).cross(axes.col(2));
  }
  return axes;
}

}  // namespace tapfit
