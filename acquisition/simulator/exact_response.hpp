// The response of a small linear structure to a force that runs in straight
// lines between its samples, without any error of time stepping.
//
//   M q'' + C q' + K q = b f(t),   a = R q''
//   x = [w0 q; q'],  x' = A x + B f,   A V = V diag(lambda),  z = V^-1 x
//   z[n+1] = e^(lambda h) z[n] + h ((phi1 - phi2) f[n] + phi2 f[n+1]) V^-1 B
//   phi1(x) = (e^x - 1)/x,   phi2(x) = (e^x - 1 - x)/x^2,   x = lambda h
//
// The matrix exponential with a first-order hold on the force (for example
// G. F. Franklin, J. D. Powell and M. Workman, "Digital Control of Dynamic
// Systems", 3rd ed., 1998, sec. 6.3), taken in complex modes so that a step
// costs as many products as there are modes. A cubic spring's force runs in
// straight lines between the samples, too: exact to order h^2.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace tapfit::acquisition {

/// A spring to ground whose force grows with the cube of its stretch.
struct CubicSpring {
  Eigen::VectorXd place;   ///< r, its stretch per q
  double stiffness = 0.0;  ///< [N/m^3]
};

/// A structure in r generalised coordinates, one force, n sensors; linear but
/// for a spring it may have.
struct SecondOrderSystem {
  Eigen::MatrixXd M;       ///< r x r, positive definite
  Eigen::MatrixXd C;       ///< r x r
  Eigen::MatrixXd K;       ///< r x r
  Eigen::VectorXd input;   ///< r, where the force acts
  Eigen::MatrixXd output;  ///< n x r, acceleration per q''
  std::optional<CubicSpring> hardening = {};
};

struct ExactResponse {
  Eigen::MatrixXd acceleration;  ///< n_samples x n [m/s^2]
  /// Its part that follows the force at once, per force [1/kg].
  Eigen::VectorXd direct;
};

/// Accelerations at the sensors, from rest.
///
/// The corners of a force in straight lines hold frequencies around the rate
/// that no smooth force has, and modes up there would answer them. Modes above
/// a limit can be taken as static instead: their pole's share of the answer,
/// l g / (s - lambda), to second order in s / lambda.
///
/// @param force samples of the force [N], linear in between
/// @param rate_hz of the samples of force and result
/// @param static_hz modes above are static; 0: none
/// @return empty when the structure has no full set of complex modes (critical
///   damping, a free undamped rigid-body mode)
[[nodiscard]] std::optional<ExactResponse> exact_response(
    const SecondOrderSystem& system,
    const Eigen::VectorXd& force,
    double rate_hz,
    double static_hz = 0.0);

/// Undamped natural frequency and damping ratio of each complex mode.
struct DampedPoles {
  Eigen::VectorXd frequency_hz;   ///< |lambda| / 2 pi, ascending
  Eigen::VectorXd damping_ratio;  ///< -Re(lambda) / |lambda|
};

/// Poles of a system, underdamped pairs only.
[[nodiscard]] DampedPoles damped_poles(const Eigen::MatrixXd& M,
                                       const Eigen::MatrixXd& C,
                                       const Eigen::MatrixXd& K);

}  // namespace tapfit::acquisition
