// What the fit of a modal model needs of all lines, summed once where they are
// many: products of
// the FRFs with the residual terms, and the sums in which poles will stand
// (cauchy_sums.hpp). Lines are weighted alike in all FRFs, w_f(k) = u_f v(k).
#pragma once

#include "modal/poles/cauchy_sums.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// Separable weights nearest to w_f(k): mean logarithms over lines and FRFs.
struct SeparableWeights {
  Eigen::VectorXd line;  ///< v, n_lines
  Eigen::VectorXd frf;   ///< u, n_frfs
};

/// @param weight w, n_lines x n_frfs
[[nodiscard]] SeparableWeights separate_weights(const Eigen::MatrixXd& weight);

struct FitSums {
  /// The weighted FRFs v u H themselves where they are few enough to go over
  /// them each time, which is exact to rounding: real over imaginary parts,
  /// 2 n_lines x n_frfs; else empty, and the sums below are there.
  Eigen::MatrixXd frfs;
  /// Of v^2 conj(s^2) y for each FRF y = u H, each residual term and s^2.
  CauchySums lines;
  Eigen::MatrixXd term_term;  ///< 2 n_terms square, weighted by v^2
  Eigen::MatrixXd term_frf;   ///< 2 n_terms x n_frfs
  double power = 0.0;         ///< sum v^2 |y|^2 over lines and FRFs

  [[nodiscard]] bool are_few() const { return frfs.size() > 0; }
};

/// @param s lines [rad/s]
/// @param H accelerance, n_lines x n_frfs
[[nodiscard]] FitSums fit_sums(const Eigen::VectorXcd& s,
                               const Eigen::MatrixXcd& H,
                               const SeparableWeights& weights);

}  // namespace tapfit::modal
