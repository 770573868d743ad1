// The modal assurance criterion and its family.
//
//   MAC(u, v) = |u^H v|^2 / ((u^H u) (v^H v))
//
// A mass matrix W between the two makes it a cross-orthogonality: 1 and 0 then
// mean what they say even where few points were measured unevenly.
//
// Source: eq. 33 of the updating paper, with the conjugate for complex shapes;
// R. J. Allemang, "The modal assurance criterion", Sound and Vibration, 2003;
// MACCO: E. Balmes, "Structural Dynamics Toolbox", ii_mac.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

/// MAC of every column of U with every column of V; 0 for a zero column.
///
/// @param U n_dof x p shapes
/// @param V n_dof x q shapes
/// @return p x q, each entry 0..1
[[nodiscard]] Eigen::MatrixXd mac(const Eigen::MatrixXcd& U,
                                  const Eigen::MatrixXcd& V);

/// MAC of a set of shapes among themselves: large off its diagonal where the
/// measured points cannot tell two modes apart.
///
/// @return p x p, symmetric, 1 on the diagonal
[[nodiscard]] Eigen::MatrixXd auto_mac(const Eigen::MatrixXcd& U);

/// MAC in the inner product u^H W v.
///
/// @param W n_dof x n_dof, symmetric, positive definite: a model's mass matrix
///   reduced to the measured degrees of freedom [kg]
/// @return p x q, each entry 0..1
[[nodiscard]] Eigen::MatrixXd mass_weighted_mac(const Eigen::MatrixXcd& U,
                                                const Eigen::MatrixXcd& V,
                                                const Eigen::MatrixXd& W);

/// A model's mass at the measured degrees of freedom: those not measured follow
/// statically (Guyan's reduction, from the modes instead of the matrices),
///
///   W = A^-1 B A^-1,  A = V L^-1 V',  B = V L^-2 V',  L = omega^2
///
/// Source: R. J. Guyan, "Reduction of stiffness and mass matrices", AIAA
/// Journal 3(2), 1965; A and B are K^-1 and K^-1 M K^-1 at the measured degrees
/// of freedom.
/// @param V n_dof x q shapes of unit modal mass, as many as the model has: with
///   modes above those compared and static responses it converges
/// @param omega q [rad/s]; those of a free body (0) are taken as a thousandth
///   of the lowest elastic one
/// @return n_dof x n_dof [kg]; degrees of freedom that move as one share their
///   mass
[[nodiscard]] Eigen::MatrixXd condensed_mass(const Eigen::MatrixXd& V,
                                             const Eigen::VectorXd& omega);

/// Coordinate MAC of paired shapes: how well each degree of freedom agrees
/// over all pairs.
///
/// @param U, V n_dof x p; column k of one belongs to column k of the other, in
///   one scale over all columns (see in_scale_of)
/// @return n_dof values, each 0..1
[[nodiscard]] Eigen::VectorXd comac(const Eigen::MatrixXcd& U,
                                    const Eigen::MatrixXcd& V);

/// Each column of U times the number by which it is nearest to that of V,
/// (u^H v) / (u^H u): measured shapes may have a scale of their own each.
/// @param U, V n_dof x p
[[nodiscard]] Eigen::MatrixXcd in_scale_of(const Eigen::MatrixXcd& U,
                                           const Eigen::MatrixXcd& V);

/// One step of MACCO: the degree of freedom left out and what remains.
struct LeftOut {
  Eigen::Index dof = 0;   ///< row of the shapes
  double mean_mac = 0.0;  ///< over the pairs, without this and all before
};

/// MAC contribution of the sensors: leaves out, one after the other, the
/// degree of freedom without which the mean MAC of the pairs is highest. A
/// sensor of wrong polarity or place comes first, with a jump.
///
/// @param U, V n_dof x p; column k of one belongs to column k of the other
/// @param most steps; at least one degree of freedom stays
[[nodiscard]] std::vector<LeftOut> macco(const Eigen::MatrixXcd& U,
                                         const Eigen::MatrixXcd& V,
                                         Eigen::Index most);

/// A MAC with what noise in the measured shape does to it.
struct MacEstimate {
  double value = 0.0;  ///< noise makes it too small on average; taken out
  double sd = 0.0;
  double lo95 = 0.0;
  double hi95 = 0.0;
};

/// MAC of a measured shape with one that is known, and its uncertainty.
///
/// Errors of the points are taken as independent and circular. To second
/// order, because at MAC = 1 the first derivative vanishes: there the noise can
/// only take away.
///
/// @param u measured shape
/// @param sd sqrt(E|du|^2) of each value of u
/// @param v the other shape, taken as exact
[[nodiscard]] MacEstimate mac_with_uncertainty(const Eigen::VectorXcd& u,
                                               const Eigen::VectorXd& sd,
                                               const Eigen::VectorXcd& v);

}  // namespace tapfit::modal
