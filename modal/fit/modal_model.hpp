// The modal model as it was fitted to FRFs: see modal_fit.hpp.
#pragma once

#include <Eigen/Core>

namespace tapfit::modal {

struct ModalFit {
  Eigen::VectorXcd poles;      ///< [rad/s], upper half plane, n_modes
  Eigen::MatrixXcd residues;   ///< of receptance, n_frfs x n_modes
  Eigen::MatrixXcd terms;      ///< of residual_basis, n_frfs x n_terms
  Eigen::VectorXd frf_weight;  ///< u, n_frfs
  /// Weighted squares of what is left of the FRFs.
  double misfit = 0.0;
  /// F of each mode: the drop in weighted residual that its residues earn, per
  /// parameter, over the residual's variance around its frequency.
  Eigen::VectorXd significance;
  /// Mode's part of H at its own frequency over all of H there, both rms over
  /// the FRFs.
  Eigen::VectorXd contribution;
};

}  // namespace tapfit::modal
