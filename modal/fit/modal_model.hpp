// The modal model as it was fitted to FRFs: see modal_fit.hpp.
#pragma once

#include <Eigen/Core>

namespace tapfit::modal {

struct ModalFit {
  Eigen::VectorXcd poles;       ///< [rad/s], upper half plane, n_modes
  Eigen::MatrixXcd residues;    ///< of receptance, n_frfs x n_modes
  Eigen::MatrixXcd terms;       ///< of residual_basis, n_frfs x n_terms
  Eigen::MatrixXcd H;           ///< fitted accelerance, n_lines x n_frfs
  Eigen::VectorXd line_weight;  ///< v, n_lines
  Eigen::VectorXd frf_weight;   ///< u, n_frfs
  Eigen::VectorXd leverage;     ///< share of a line's noise that the residues
                                ///< and terms follow, n_lines
  /// F of each mode: the drop in weighted residual that its residues earn, per
  /// parameter, over the residual's variance around its frequency.
  Eigen::VectorXd significance;
  /// Mode's part of H at its own frequency over all of H there, both rms over
  /// the FRFs.
  Eigen::VectorXd contribution;
};

}  // namespace tapfit::modal
