// The modes of a pole that several share, as the pairs of a square plate or a
// disc do, or that lie too near each other for poles of their own. Where their
// distances stand out of the noise, the expansion (double_poles.hpp) gives each
// its pole and its shape. Where they do not, only the sum is known,
//
//   2 j omega_d R_ab = sum_k phi_ak phi_bk     (unit modal mass)
//
// From the n singular directions P = A B' every such product is A X, B X^-T.
// Rows of driving points are the same on both sides, A_d X = B_d X^-T, so that
// X X' = A_d^+ B_d leaves a rotation open: shapes of equal poles are any basis
// of their space. Taken is the one that is orthogonal over the outputs.
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/poles/identify_options.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

struct ModesOfPole {
  Eigen::VectorXcd poles;     ///< [rad/s]; all the same where not told apart
  double deviation = 0.0;     ///< of their distances [rad/s]
  Eigen::MatrixXcd residues;  ///< of receptance, n_frfs x n_modes
  Eigen::Index shapes = 1;    ///< that the residues hold, taken apart or not

  [[nodiscard]] bool are_equal() const { return poles(0) == poles(1); }
};

/// What is under pole r of a fit.
///
/// @param scaled whether the set's shapes have unit modal mass
/// @return residues that add up to those of the fit. One mode where the rank
///   does not stand out of the noise, the parts do not move in phase, or the
///   driving points are too few to give each shape its scale
[[nodiscard]] ModesOfPole modes_of_pole(const WeightedFrfs& curves,
                                        const ModalFit& fit,
                                        Eigen::Index r,
                                        bool scaled,
                                        const IdentifyOptions& options);

}  // namespace tapfit::modal
