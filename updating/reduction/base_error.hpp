// How far the FRFs through a reduced base are off those of the whole model.
//
// V is a Galerkin basis: with R = F - Z V q what the reduced answer q leaves of
// unit forces F, the receptances miss exactly R' Z^-1 R. R is nothing to the
// modes that V has, and on all higher ones Z is K + shift M but for
// (omega / omega_r)^2, so that the model's factored matrix gives it.
#pragma once

#include "updating/reduction/residual_flexibility.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::updating {

/// @param V n x r, M-orthonormal, V' K V diagonal
/// @param stiffness diagonal of V' K V
/// @param points degrees of freedom that are hit or measured
/// @param high_hz top of the band
/// @return largest over the band of ||H_reduced - H|| / ||H|| over all pairs of
///   the points, on s = omega (0.03 + j)
[[nodiscard]] double base_error(const structure::System& system,
                                const ResidualFlexibility& answers,
                                const Eigen::MatrixXd& V,
                                const Eigen::VectorXd& stiffness,
                                const std::vector<int>& points,
                                double high_hz);

/// A sentence when that is more than a thousandth; else empty.
[[nodiscard]] std::string base_error_warning(double error);

}  // namespace tapfit::updating
