// What a deck that is wrong in form does to what a fit leaves, and how the
// fit's parameters may answer: all that form_error.hpp needs.
#pragma once

#include "updating/fit/updater.hpp"
#include "updating/frf_model/form_error.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/residual/residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// What a form that is wrong adds to what a model leaves.
/// @return rows of stack() x patterns, see FrfModel::form_patterns()
[[nodiscard]] Eigen::MatrixXd form_bias(const FrfModel& model,
                                        const ModelState& state,
                                        const Target& target);

/// How the parameters of a result may still move; those at a bound may not.
[[nodiscard]] Readjustment readjustment(const UpdateResult& result);

}  // namespace tapfit::updating
