// An FRF freed of masses that loaded the structure when it was measured.
//
// With the masses M = diag(m_t) at the points T, the accelerances A of the
// loaded structure give those of the free one by Sherman, Morrison and
// Woodbury with a negative mass (Z0 = Z - s^2 B M B'):
//
//   A0_ij = A_ij + A_iT (M^-1 - A_TT)^-1 A_Tj,   one mass at i: A_ij/(1 - m
//   A_ii)
//
// and with c = (M^-1 - A_TT)^-1 A_Tj, r = A_iT (M^-1 - A_TT)^-1 to first order
//
//   dA0 = dA_ij + dA_iT c + r dA_Tj + r dA_TT c + sum_t r_t c_t dm_t / m_t^2.
//
// Errors of one and the same measurement are added before they are squared,
// those of different ones are taken as independent.
//
// Sources: J. Sherman, W. J. Morrison, Ann. Math. Stat. 21, 1950, p. 124-127;
// O. Cakar, K. Y. Sanliturk, "Elimination of transducer mass loading effects
// from frequency response functions", MSSP 19, 2005, p. 87-104.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace tapfit::signal {

/// An accelerance of the loaded structure that enters a removal.
struct LoadedEntry {
  const Eigen::VectorXcd* H = nullptr;        ///< lines [(m/s^2)/N]
  const Eigen::VectorXd* variance = nullptr;  ///< E|dH|^2, lines; or empty
  double sign = 1.0;                          ///< turns H to the axes' signs
  std::size_t source = 0;  ///< the same number for the same measurement
};

/// Everything that one freed FRF needs; k directions in which masses sit.
struct MassRemoval {
  LoadedEntry wanted;               ///< A_ij
  std::vector<LoadedEntry> row;     ///< A_iT, k
  std::vector<LoadedEntry> column;  ///< A_Tj, k
  std::vector<LoadedEntry> core;    ///< A_TT, k x k, row after row
  Eigen::VectorXd kg;               ///< k, above 0
  Eigen::VectorXd sd_kg;            ///< k, standard deviations
  std::vector<std::size_t> mass;    ///< k; directions of one mass share dm
};

struct FreedCurve {
  Eigen::VectorXcd H;        ///< A0_ij, lines [(m/s^2)/N]
  Eigen::VectorXd variance;  ///< E|dA0|^2, lines
};

/// Takes the masses off one FRF.
///
/// @return empty when at some line M^-1 - A_TT is singular to working
///   precision: the masses are all that moves there
[[nodiscard]] std::optional<FreedCurve> remove_masses(
    const MassRemoval& removal);

}  // namespace tapfit::signal
