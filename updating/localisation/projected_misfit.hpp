// The present misfit and what candidate changes of the FRFs would leave of it,
// everything else that is fitted readjusting to first order.
#pragma once

#include "updating/fit/fitter.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

class ProjectedMisfit {
 public:
  ProjectedMisfit(const Fit& current, const Target& target);

  /// What a change has to be compared with, as stacked residuals: column
  /// `misfit` what is left to explain, column `missing` all that is missing,
  /// from `tangent` on an orthonormal basis of what readjusts.
  [[nodiscard]] const Eigen::MatrixXd& directions() const {
    return directions_;
  }
  static constexpr Eigen::Index misfit = 0;
  static constexpr Eigen::Index missing = 1;
  static constexpr Eigen::Index tangent = 2;

  /// Real residual vector of a change of the FRFs (lines x FRFs).
  [[nodiscard]] Eigen::VectorXd change(const Eigen::MatrixXcd& dH) const;

  /// Error left with no change at all.
  [[nodiscard]] double unchanged() const;

  /// Error left with each of several changes made as they are.
  /// @param power squared norms of the changes
  /// @param shared directions' products with them, a column per change
  [[nodiscard]] Eigen::VectorXd errors(const Eigen::VectorXd& power,
                                       const Eigen::MatrixXd& shared) const;
  /// @param changes one per column, as from change()
  [[nodiscard]] Eigen::VectorXd errors(const Eigen::MatrixXd& changes) const;

  /// Best factor on a change, and the error left with it; factors below zero
  /// count as zero.
  struct Scaled {
    double factor = 0.0;
    double error = 0.0;
  };
  [[nodiscard]] Scaled scaled(double power,
                              const Eigen::VectorXd& shared) const;

  /// Squared norm of all that is missing.
  [[nodiscard]] double missing_power() const { return missing_power_; }

 private:
  const Target* target_;
  Eigen::MatrixXd directions_;
  double misfit_power_ = 0.0;
  double missing_power_ = 0.0;
};

}  // namespace tapfit::updating
