// Which measured mode is which mode of the model: the assignment with the
// largest total score, where
//
//   score = MAC exp(-((f_model - f_measured) / (tolerance f_measured))^2 / 2)
//
// so that two similar shapes (few sensors alias them) are told apart by
// frequency.
// Source of the assignment: H. W. Kuhn, "The Hungarian method for the
// assignment problem", Naval Research Logistics Quarterly 2, 1955.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

struct Pair {
  Eigen::Index measured = 0;  ///< column of the measured shapes
  Eigen::Index model = 0;     ///< column of the model's shapes
};

struct PairingOptions {
  double frequency_tolerance = 0.15;  ///< relative
  double least_mac = 0.3;             ///< pairs below are not made
};

/// @param measured n_dof x p shapes
/// @param measured_hz p frequencies
/// @param model n_dof x q shapes at the same degrees of freedom
/// @param model_hz q frequencies
/// @return at most min(p, q) pairs, ascending in measured frequency column
[[nodiscard]] std::vector<Pair> pair_modes(const Eigen::MatrixXcd& measured,
                                           const Eigen::VectorXd& measured_hz,
                                           const Eigen::MatrixXcd& model,
                                           const Eigen::VectorXd& model_hz,
                                           const PairingOptions& options);

/// Column of each row in the assignment of least total cost.
///
/// @param cost p x q, p <= q, finite
[[nodiscard]] std::vector<Eigen::Index> assign(const Eigen::MatrixXd& cost);

}  // namespace tapfit::modal
