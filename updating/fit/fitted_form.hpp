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
/// @return of stack(), see FrfModel::form_patterns()
[[nodiscard]] FormError form_error(const FrfModel& model,
                                   const ModelState& state,
                                   const Target& target);

/// Behind those of the modes: even, linear and, in FRFs, of the modes above the
/// band.
[[nodiscard]] Eigen::Index common_patterns(const Target& target);

/// Its patterns, each at its deviation: tau, as what a fit leaves tells it, and
/// what the mesh leaves. What all modes have in common, evenly or in proportion
/// to their frequency, the modulus takes, and nothing that is left tells of it:
/// no less than a careful deck is wrong by.
/// @param tau relative, of a modal stiffness
[[nodiscard]] Eigen::MatrixXd likely_form_bias(const FormError& form,
                                               double tau,
                                               double allowance,
                                               const Target& target);

/// How the parameters of a result may still move; those at a bound may not.
[[nodiscard]] Readjustment readjustment(const UpdateResult& result);

/// What a fit leaves, from a deck that may be wrong in form.
struct FittedForm {
  FormView view;
  double log_likelihood = 0.0;  ///< see FormEstimate
  Eigen::MatrixXd bias;         ///< see Target::form_bias
};

/// @param result of a fit of that model to that target
[[nodiscard]] FittedForm fitted_form(const FrfModel& model,
                                     const UpdateResult& result,
                                     const Target& target,
                                     double allowance);

}  // namespace tapfit::updating
