// Which absorber would give a missing dynamic stiffness: a mass on a spring and
// a dashpot, which shows around its own resonance alone,
//
//   z(s) = m s^2 (2 zeta w s + w^2) / (s^2 + 2 zeta w s + w^2).
//
// The mass follows from w and zeta by least squares; these are sought on the
// lines first, then by halving steps around the best.
// Source: J. P. Den Hartog, "Mechanical Vibrations", section 3.3.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

/// A mass on a spring and a dashpot; see absorber_stiffness().
struct AbsorberLaw {
  double mass_kg = 0.0;
  double frequency_hz = 0.0;
  double damping_ratio = 0.0;
  double unexplained = 1.0;  ///< share of z that it leaves
};

/// How well a law explains a missing stiffness.
struct LawFit {
  double size = 0.0;         ///< factor on the law
  double unexplained = 1.0;  ///< share of z left, in the same weights
};

/// Least squares of z = size * law.
/// @param z, weight, law one per line
[[nodiscard]] LawFit fit_law(const Eigen::VectorXcd& z,
                             const Eigen::VectorXd& weight,
                             const Eigen::VectorXcd& law);

/// z(s) of an absorber [N/m].
/// @param s lines [rad/s]
[[nodiscard]] Eigen::VectorXcd absorber_stiffness(const AbsorberLaw& absorber,
                                                  const Eigen::VectorXcd& s);

/// @return one that resonates on the lines; a mass of zero where none explains
///   anything
[[nodiscard]] AbsorberLaw fit_absorber(const Eigen::VectorXcd& z,
                                       const Eigen::VectorXd& weight,
                                       const Eigen::VectorXcd& s);

}  // namespace tapfit::updating
