// How complex a mode shape is, and the real shape nearest to it. A mode of
// proportional damping is real but for a common phase.
#pragma once

#include <Eigen/Core>

#include <complex>

namespace tapfit::modal {

/// exp(j angle) that turns a shape so that its real part is as large as
/// possible: half the angle of sum phi^2 back.
[[nodiscard]] std::complex<double> turn_to_real(const Eigen::VectorXcd& shape);

/// The shape normalised to real values: the real part once turned so. It keeps
/// its scale and, being turned by a quarter at most, its sign.
[[nodiscard]] Eigen::VectorXd real_shape(const Eigen::VectorXcd& shape);

/// MPC below which points are said not to move in phase.
inline constexpr double in_phase_mpc = 0.7;

/// Modal phase collinearity: 1 when all points move in phase or opposite.
///   MPC = (lambda_1 - lambda_2)^2 / (lambda_1 + lambda_2)^2
/// with the eigenvalues of the 2 x 2 scatter of real and imaginary parts.
/// Source: Pappa, Elliott, Schenk, J. Guidance 16(5), 1993.
[[nodiscard]] double phase_collinearity(const Eigen::VectorXcd& shape);

/// Mean phase deviation of a shape's points from the line that they lie on in
/// the complex plane, weighted by their size: 0 for a real shape, up to 90.
///   MPD = sum_k |phi_k| acos(|Re(phi_k conj(u))| / |phi_k|) / sum_k |phi_k|
/// with u of unit length along the principal axis.
/// Source: E. Reynders, J. Houbrechts, G. De Roeck, "Fully automated
/// (operational) modal analysis", MSSP 29, 2012, p. 228-250.
/// @return [deg]; 0 for a shape of zeros
[[nodiscard]] double mean_phase_deviation(const Eigen::VectorXcd& shape);

}  // namespace tapfit::modal
