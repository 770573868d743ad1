// The present misfit and what candidate changes of the FRFs would leave of it,
// everything else that is fitted readjusting to first order.
#pragma once

#include "updating/fitter.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

class MisfitScan {
 public:
  MisfitScan(const Fit& current, const Target& target);

  /// Real residual vector of a change of the FRFs (lines x FRFs).
  [[nodiscard]] Eigen::VectorXd change(const Eigen::MatrixXcd& dH) const;

  /// Error left with each of several changes made as they are.
  /// @param changes one per column, as from change()
  [[nodiscard]] Eigen::VectorXd errors(const Eigen::MatrixXd& changes) const;

  /// Best factor on a change, and the error left with it; factors below zero
  /// count as zero.
  struct Scaled {
    double factor = 0.0;
    double error = 0.0;
  };
  [[nodiscard]] Scaled scaled(const Eigen::VectorXd& change) const;

  /// Error left by any law of frequency at one place: the best multiple of
  /// the pattern at every line by itself, nothing readjusting.
  [[nodiscard]] double any_law(const Eigen::MatrixXcd& pattern) const;

 private:
  const Target* target_;
  Eigen::MatrixXcd missing_;  // model - measured
  Eigen::VectorXd misfit_;    // of it, off the tangent space
  Eigen::MatrixXd Q_;         // orthonormal basis of the tangent space
};

}  // namespace tapfit::updating
