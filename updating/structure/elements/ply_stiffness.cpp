#include "updating/structure/elements/ply_stiffness.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>

namespace tapfit::structure {

Eigen::Matrix3d plane_stress(const Material& m) {
  if (m.is_plane()) return m.plane;
  const double E2 = m.orthotropic ? m.E2 : m.E;
  const double nu21 = m.nu * E2 / m.E;
  const double q = 1.0 - m.nu * nu21;
  const double G = m.orthotropic ? m.G : m.E / (2.0 * (1.0 + m.nu));
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();
  Q(0, 0) = m.E / q;
  Q(1, 1) = E2 / q;
  Q(0, 1) = Q(1, 0) = m.nu * E2 / q;
  // An isotropic material with its own G is kept as the deck gives it.
  Q(2, 2) = !m.orthotropic && m.G > 0.0 ? m.G : G;
  return Q;
}

Eigen::Matrix3d strain_rotation(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Eigen::Matrix3d T;
  T << c * c, s * s, c * s,  //
      s * s, c * c, -c * s,  //
      -2 * c * s, 2 * c * s, c * c - s * s;
  return T;
}

Eigen::Matrix2d transverse_compliance(const Material& m, double angle) {
  Eigen::Matrix2d flexible = Eigen::Matrix2d::Zero();
  if (m.is_plane()) {
    // As MID3 the moduli of a MAT2 are those of transverse shear.
    flexible = m.plane.topLeftCorner<2, 2>().inverse();
  } else {
    const double G1 = m.orthotropic ? m.G1z : m.G;
    const double G2 = m.orthotropic ? m.G2z : m.G;
    if (G1 > 0.0) flexible(0, 0) = 1.0 / G1;
    if (G2 > 0.0) flexible(1, 1) = 1.0 / G2;
  }
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R * flexible * R.transpose();
}

const Material& layer_material(const Deck& deck, int id, const Shell& shell) {
  const Material& m = deck.materials.at(id);
  const auto place = [&] {
    return card_place(deck, shell.where, fmt::format("shell {}", shell.id));
  };
  if (m.is_solid()) {
    throw InputError(fmt::format("material {} is one of solids", id),
                     place(),
                     "Name a MAT1, MAT2 or MAT8.");
  }
  if (!(m.E > 0.0)) {
    throw InputError(fmt::format("material {} has no stiffness", id),
                     place(),
                     "Give E and NU (or G) above zero.");
  }
  return m;
}

}  // namespace tapfit::structure
