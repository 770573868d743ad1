// Stiffness of a layer in its plane and across it, by its material.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

namespace tapfit::structure {

/// Plane stress along the material's axes, for (exx, eyy, 2 exy) [Pa].
[[nodiscard]] Eigen::Matrix3d plane_stress(const Material& m);

/// Strains (with 2 exy) along axes turned by an angle from those along the
/// element's. @param angle [rad]
[[nodiscard]] Eigen::Matrix3d strain_rotation(double angle);

/// Of the moduli of transverse shear, along the element's axes [1/Pa]; zero
/// where the material is stiff in shear.
[[nodiscard]] Eigen::Matrix2d transverse_compliance(const Material& m,
                                                    double angle);

/// @throws InputError naming the shell for a material without stiffness, or one
///   that is a solid's
[[nodiscard]] const Material& layer_material(const Deck& deck,
                                             int id,
                                             const Shell& shell);

}  // namespace tapfit::structure
