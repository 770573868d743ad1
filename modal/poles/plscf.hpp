// The room modal/poles. Poles that FRFs suggest, order by order.
// In:  FRFs.
// Out: Weighted FRFs in one matrix, poles per model order, the stabilisation
//      diagram and its tracks. Which of them are modes is decided in
//      modal/select.
// May include: its row in CONTRIBUTING.md.
//
// Poles by the poly-reference least-squares complex frequency method (pLSCF).
//
//   H(k) = B(Omega_k) A(Omega_k)^-1,  Omega_k = exp(-j (omega_k - omega_0) dt)
//
// with real matrix polynomials in Omega. The numerators, of the largest degree
// for every degree of A, are eliminated, which leaves the reduced normal
// equations M alpha = 0. Those of a lower degree are a leading block of M: one
// factorisation serves all orders. The highest coefficient of A is the
// identity: with this sign of Omega the poles of noise then come out unstable
// and only those of the structure have positive damping.
//
// Source: B. Peeters et al., "The PolyMAX frequency-domain method", Shock and
// Vibration 11, 2004, p. 395-409; P. Guillaume et al., "A poly-reference
// implementation of the least-squares complex frequency-domain estimator",
// IMAC 21, 2003; B. Cauberghe et al., "The influence of the parameter
// constraint on the stability of the poles", MSSP 19, 2005.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/poles/frf_matrix.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <vector>

namespace tapfit::modal {

/// Damped poles of one model order, upper half plane only, sigma taken out.
struct OrderPoles {
  int order = 0;                   ///< pairs of conjugate poles in the model
  Eigen::VectorXcd poles;          ///< [rad/s], negative real parts
  Eigen::MatrixXcd participation;  ///< n_references x n_poles, unit columns
};

/// Poles for every order up to the largest.
///
/// @param max_order largest number of pole pairs; cut to what the lines carry
[[nodiscard]] std::vector<OrderPoles> plscf_poles(const WeightedFrfs& curves,
                                                  const FrfMatrix& matrix,
                                                  int max_order,
                                                  const Progress& progress);

}  // namespace tapfit::modal
