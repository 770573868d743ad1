// Through-thickness stiffness and mass of a shell, in the element's axes.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

namespace tapfit::structure {

struct ShellSection {
  Eigen::Matrix3d membrane;  ///< for (exx, eyy, 2 exy) [N/m]; zero: absent
  Eigen::Matrix3d bending;   ///< for (kxx, kyy, 2 kxy) [N m]; zero: absent
  Eigen::Matrix2d shear_compliance;  ///< [m/N]; zero: stiff in shear
  double mass = 0.0;                 ///< [kg/m^2]
  double rotary = 0.0;               ///< [kg]
};

/// @throws InputError when a material has no stiffness
[[nodiscard]] ShellSection shell_section(const Deck& deck, const Shell& shell);

}  // namespace tapfit::structure
