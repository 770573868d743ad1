#include "updating/structure/elements/shell_section.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

// Plane stress in the material's axes.
Eigen::Matrix3d plane_stress(const Material& m) {
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

// Strains (with 2 exy) in material axes from those in element axes.
Eigen::Matrix3d strain_rotation(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Eigen::Matrix3d T;
  T << c * c, s * s, c * s,  //
      s * s, c * c, -c * s,  //
      -2 * c * s, 2 * c * s, c * c - s * s;
  return T;
}

Eigen::Matrix2d shear_compliance(const Material& m,
                                 double thickness,
                                 double angle) {
  const double G1 = m.orthotropic ? m.G1z : m.G;
  const double G2 = m.orthotropic ? m.G2z : m.G;
  const Eigen::Vector2d flexible(G1 > 0.0 ? 1.0 / (G1 * thickness) : 0.0,
                                 G2 > 0.0 ? 1.0 / (G2 * thickness) : 0.0);
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R * flexible.asDiagonal() * R.transpose();
}

const Material& stiff_material(const Deck& deck, int id, const Shell& shell) {
  const Material& m = deck.materials.at(id);
  if (!(m.E > 0.0)) {
    throw InputError(
        fmt::format("material {} has no stiffness", id),
        card_place(deck, shell.where, fmt::format("shell {}", shell.id)),
        "Give E and NU (or G) above zero.");
  }
  return m;
}

}  // namespace

ShellSection shell_section(const Deck& deck, const Shell& shell) {
  const double angle = shell.theta_deg * std::numbers::pi / 180.0;
  const ShellProperty& p = deck.shell_properties.at(shell.property);
  const double t = p.thickness;
  const Eigen::Matrix3d T = strain_rotation(angle);
  ShellSection section;
  section.membrane.setZero();
  section.bending.setZero();
  section.shear_compliance.setZero();
  section.mass = p.nonstructural;
  if (p.membrane != 0) {
    const Material& m = stiff_material(deck, p.membrane, shell);
    section.membrane = T.transpose() * plane_stress(m) * T * t;
    section.mass += m.rho * t;
    section.rotary = m.rho * t * t * t / 12.0;
  }
  if (p.bending != 0) {
    const Material& m = stiff_material(deck, p.bending, shell);
    const double I = p.bending_ratio * t * t * t / 12.0;
    section.bending = T.transpose() * plane_stress(m) * T * I;
    if (p.membrane == 0) {
      section.mass += m.rho * t;
      section.rotary = m.rho * t * t * t / 12.0;
    }
  }
  if (p.shear != 0 && p.bending != 0) {
    section.shear_compliance =
        shear_compliance(deck.materials.at(p.shear), p.shear_ratio * t, angle);
  }
  return section;
}

}  // namespace tapfit::structure
