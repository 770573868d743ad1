// Sensitivity of FRFs to a parameter P, from the initial FRFs alone.
//
//   analytic            S = -H (d Z / d P) H                         (eq. 4)
//   finite perturbation S = -H U (I + V' H U)^-1 V' H / Delta P      (eq. 16)
//
// with Delta Z = U V' from its rank-revealing QR decomposition: only as many
// equations are solved as the perturbation has ranks. H and Z may be those of
// a whole model or of its reduced base. The finite perturbation is what a full
// solution of the perturbed model would give (eq. 15).
// Source: "Model Updating Using Frequency Response Functions Based on
// Sherman-Morrison Formula", equations 4 to 16 and 31.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace tapfit::updating {

/// Delta Z = U V'.
struct LowRankChange {
  Eigen::MatrixXcd U;  ///< n x rank
  Eigen::MatrixXcd V;  ///< n x rank, transposed without conjugation
};

/// @param dZ n x n, change of the dynamic stiffness
[[nodiscard]] LowRankChange factor_change(const Eigen::MatrixXcd& dZ);

/// H* = H - H U (I + V' H U)^-1 V' H (eq. 15).
///
/// @param H n x n receptance
/// @return empty when the changed structure is singular to working precision
[[nodiscard]] std::optional<Eigen::MatrixXcd> changed_receptance(
    const Eigen::MatrixXcd& H, const LowRankChange& change);

/// (H* - H) / Delta P (eq. 16).
/// @param dZ change of the dynamic stiffness that Delta P causes
[[nodiscard]] std::optional<Eigen::MatrixXcd> finite_sensitivity(
    const Eigen::MatrixXcd& H, const LowRankChange& dZ, double dP);

/// -H (d Z / d P) H (eq. 4).
[[nodiscard]] Eigen::MatrixXcd analytic_sensitivity(
    const Eigen::MatrixXcd& H, const Eigen::MatrixXcd& dZ_dP);

/// Mean of |exact - approximate| / |exact| over the points of two curves
/// (eq. 31; 1 is 100 %). Points where the exact curve is zero do not count.
[[nodiscard]] double sensitivity_error(const Eigen::VectorXcd& exact,
                                       const Eigen::VectorXcd& approximate);

}  // namespace tapfit::updating
