// The missing dynamic stiffness at one place.
#pragma once

#include "updating/localisation/absorber_law.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// The missing dynamic stiffness z(s) at one place against frequency.
struct Signature {
  int node = 0;
  Eigen::VectorXd frequency_hz;
  Eigen::VectorXcd z;      ///< [N/m]
  Eigen::VectorXd z_sd;    ///< [N/m]
  double explained = 0.0;  ///< share of the discrepancy one place explains
  /// Share of z left unexplained by each law: mass, spring, dashpot.
  double mass_unexplained = 1.0, mass_kg = 0.0;
  double spring_unexplained = 1.0, spring_n_per_m = 0.0;
  double dashpot_unexplained = 1.0, dashpot_ns_per_m = 0.0;
  /// Has three parameters, and so always leaves less than a mass alone.
  AbsorberLaw absorber = {};
};

/// Whether one place explains most of what is missing, so that its missing
/// stiffness means something.
[[nodiscard]] inline bool is_significant(const Signature& signature) {
  constexpr double most = 0.5;
  return signature.explained >= most;
}

}  // namespace tapfit::updating
