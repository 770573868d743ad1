// Which measured mode is which mode of the model.
//
//   score = MAC - a |ln(f_model / f_measured)|
//
// The pairs are those with the largest sum of scores (optimal assignment),
// so that one good match cannot take away another's only one. A pair must score
// above zero: shapes a little alike and frequencies far apart are no pair.
//
// Source of the assignment: H. W. Kuhn, "The Hungarian method for the
// assignment problem", Naval Research Logistics 2, 1955, p. 83-97, in the
// shortest-path form of R. Jonker, A. Volgenant, Computing 38, 1987.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

struct PairingOptions {
  double least_mac = 0.3;             ///< no pair below
  double most_frequency_ratio = 1.6;  ///< no pair further apart
  double frequency_weight = 1.0;      ///< a
};

struct Pair {
  Eigen::Index measured = 0;  ///< column of the measured shapes
  Eigen::Index model = 0;     ///< column of the model's shapes
  double mac = 0.0;
};

/// Pairs measured modes with the model's, by measured frequency.
///
/// Where fewer than three points were measured MAC says little: with one point
/// or none the frequency alone decides.
///
/// @param measured n_dof x p shapes
/// @param f_measured p [Hz]
/// @param model n_dof x q shapes at the same degrees of freedom
/// @param f_model q [Hz]; modes at 0 Hz (rigid) pair with nothing
/// @return at most min(p, q) pairs, by measured index
[[nodiscard]] std::vector<Pair> pair_modes(const Eigen::MatrixXcd& measured,
                                           const Eigen::VectorXd& f_measured,
                                           const Eigen::MatrixXcd& model,
                                           const Eigen::VectorXd& f_model,
                                           const PairingOptions& options = {});

/// The pairs with some of them set by hand: a pair given takes its two modes
/// out of the others' reach, whatever MAC and frequency say; a model index of
/// -1 leaves that measured mode without a partner.
///
/// @param by_hand measured and model index; of `mac` nothing is read
/// @throws InputError for an index that does not exist or is given twice
[[nodiscard]] std::vector<Pair> pair_modes(const Eigen::MatrixXcd& measured,
                                           const Eigen::VectorXd& f_measured,
                                           const Eigen::MatrixXcd& model,
                                           const Eigen::VectorXd& f_model,
                                           const PairingOptions& options,
                                           const std::vector<Pair>& by_hand);

/// Assignment of rows to columns with the least sum of costs.
///
/// @param cost n x m
/// @return per row its column; -1 where none is left at a finite cost
[[nodiscard]] std::vector<Eigen::Index> assign(const Eigen::MatrixXd& cost);

}  // namespace tapfit::modal
