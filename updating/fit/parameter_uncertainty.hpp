// How far the identified parameters can be trusted.
#pragma once

#include "updating/fit/residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Covariance of theta from the final Jacobian.
///
/// Two estimates: with the residual's own variance and the independent data
/// that it holds (residual_data()), and robust against errors that all lines of
/// a run share (sandwich over runs); of each parameter the wider one counts.
/// What the mesh may be off by (Target::mesh_bias) is added as the change it
/// would cause. Source: A. C. Cameron, D. L. Miller, "A practitioner's guide to
/// cluster-robust inference", J. Human Resources 50, 2015.
///
/// @param J (2 lines FRFs) x n, of stack()
/// @param r residual of the same length
/// @param prior_sd n, infinite where there is no prior
[[nodiscard]] Eigen::MatrixXd parameter_covariance(
    const Target& target,
    const Eigen::MatrixXd& J,
    const Eigen::VectorXd& r,
    const Eigen::VectorXd& prior_sd);

/// The covariance widened to what is known where the deck may be wrong in form:
/// of each parameter the wider one counts, and none is wider than its prior.
///
/// @param information n x n, see FormEstimate::information
[[nodiscard]] Eigen::MatrixXd widened_by_form(
    const Eigen::MatrixXd& covariance,
    const Eigen::MatrixXd& information,
    const Eigen::VectorXd& prior_sd);

}  // namespace tapfit::updating
