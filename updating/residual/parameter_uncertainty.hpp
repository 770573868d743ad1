// How far the identified parameters can be trusted.
#pragma once

#include "updating/residual/residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

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
/// @param J (2 lines FRFs) x n, of stack()
/// @param r residual of the same length
/// @param prior_sd n, infinite where there is no prior
[[nodiscard]] Eigen::MatrixXd parameter_covariance(
    const Target& target,
    const Eigen::MatrixXd& J,
    const Eigen::VectorXd& r,
    const Eigen::VectorXd& prior_sd);

}  // namespace tapfit::updating
