#include "updating/structure/elements/shell_section.hpp"

#include "updating/structure/elements/laminate.hpp"
#include "updating/structure/elements/ply_stiffness.hpp"

#include <Eigen/Dense>

#include <numbers>

namespace tapfit::structure {

ShellSection shell_section(const Deck& deck, const Shell& shell) {
  const double angle = shell.theta_deg * std::numbers::pi / 180.0;
  const ShellProperty& p = deck.shell_properties.at(shell.property);
  if (!p.plies.empty()) return laminate_section(deck, shell, p);
  const double t = shell.thickness > 0.0 ? shell.thickness : p.thickness;
  const Eigen::Matrix3d T = strain_rotation(angle);
  ShellSection section;
  section.membrane.setZero();
  section.bending.setZero();
  section.shear_compliance.setZero();
  section.mass = p.nonstructural;
  if (p.membrane != 0) {
    const Material& m = layer_material(deck, p.membrane, shell);
    section.membrane = T.transpose() * plane_stress(m) * T * t;
    section.mass += m.rho * t;
    section.rotary = m.rho * t * t * t / 12.0;
  }
  if (p.bending != 0) {
    const Material& m = layer_material(deck, p.bending, shell);
    const double I = p.bending_ratio * t * t * t / 12.0;
    section.bending = T.transpose() * plane_stress(m) * T * I;
    if (p.membrane == 0) {
      section.mass += m.rho * t;
      section.rotary = m.rho * t * t * t / 12.0;
    }
  }
  if (p.shear != 0 && p.bending != 0) {
    section.shear_compliance =
        transverse_compliance(deck.materials.at(p.shear), angle) /
        (p.shear_ratio * t);
  }
  if (p.coupling != 0 && p.membrane != 0 && p.bending != 0) {
    const Material& m = deck.materials.at(p.coupling);
    section.coupling = T.transpose() * plane_stress(m) * T * t * t;
  }
  return section;
}

}  // namespace tapfit::structure
