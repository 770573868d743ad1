// How far the identified parameters can be trusted.
#pragma once

#include "updating/residual/residual.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// What a fit leaves of one test.
struct FittedResidual {
  const Target& target;
  const Eigen::MatrixXd& J;  ///< (2 lines FRFs) x n, of stack()
  const Eigen::VectorXd& r;  ///< residual of the same length
  Eigen::Index parameters;   ///< that move it: its columns that are not zero
  /// Of each column of target.form_bias which deviation of the deck it is: one
  /// that tests share drives all of them at once. Empty: as they are counted.
  std::vector<int> deviation = {};
};

/// Covariance of theta from the final Jacobian.
///
/// Two estimates: with the residual's own variance and the independent data
/// that it holds (residual_data()), and robust against errors that all lines of
/// a run share (sandwich over runs); of each parameter the wider one counts.
/// What the mesh and the deck's form may be off by (Target::form_bias) is added
/// as the change it would cause. Source: A. C. Cameron, D. L. Miller, "A
/// practitioner's guide to cluster-robust inference", J. Human Resources 50,
/// 2015.
///
/// @param prior_sd n, infinite where there is no prior
/// @param known d k / d theta of other data in their deviations, rows x n
[[nodiscard]] Eigen::MatrixXd parameter_covariance(
    const Target& target,
    const Eigen::MatrixXd& J,
    const Eigen::VectorXd& r,
    const Eigen::VectorXd& prior_sd,
    const Eigen::MatrixXd& known = {});

/// The same of several tests that were fitted together, each with a variance
/// and runs of its own. What a deck that they share is wrong by does not
/// average out.
[[nodiscard]] Eigen::MatrixXd parameter_covariance(
    const std::vector<FittedResidual>& tests,
    const Eigen::VectorXd& prior_sd,
    const Eigen::MatrixXd& known = {});

}  // namespace tapfit::updating
