// What a shell is through its thickness: stiffness and mass per area, in the
// element's axes.
#pragma once

#include <Eigen/Core>

namespace tapfit::structure {

struct ShellSection {
  Eigen::Matrix3d membrane;  ///< for (exx, eyy, 2 exy) [N/m]; zero: absent
  Eigen::Matrix3d bending;   ///< for (kxx, kyy, 2 kxy) [N m]; zero: absent
  Eigen::Matrix2d shear_compliance;  ///< [m/N]; zero: stiff in shear
  double mass = 0.0;                 ///< [kg/m^2]
  double rotary = 0.0;               ///< [kg]
  /// Membrane forces by curvature and moments by strain [N].
  Eigen::Matrix3d coupling = Eigen::Matrix3d::Zero();

  [[nodiscard]] bool is_coupled() const { return !coupling.isZero(0.0); }
  /// Bending about the plane in which it takes least, D - B A^-1 B.
  [[nodiscard]] Eigen::Matrix3d least_bending() const;
};

}  // namespace tapfit::structure
