// FRFs after a known change, and how far they can be trusted. To first order
// an FRF is off by sum_k dH / d theta_k d theta_k + sum_p tau F_p, theta with
// the covariance C of the fit and F_p the patterns of the deck's form
// (FrfModel::form_patterns()):
//
//   E|dH|^2 = sum_jk dH_j* C_jk dH_k + tau^2 sum_p |F_p|^2
#pragma once

#include "updating/prediction/changed_model.hpp"
#include "updating/prediction/prediction.hpp"
#include "updating/residual/residual.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// The measured FRFs with the model's values in the place of theirs: coherence
/// 1, no hits, and no variance of hits.
[[nodiscard]] signal::FrfSet predicted_frfs(const ChangedModel& model,
                                            const signal::FrfSet& measured);

/// @param target the damped line of measured FRFs that models are compared on
/// @param covariance of theta, see parameter_spread()
/// @param form_variance tau^2 / 4
/// @return per FRF
[[nodiscard]] std::vector<FrfChange> frf_changes(
    const ChangedModel& model,
    const Target& target,
    const Eigen::MatrixXd& covariance,
    double form_variance);

}  // namespace tapfit::updating
