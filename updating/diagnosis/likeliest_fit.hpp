// From a fit to the least residual to the likeliest one: where the deck may be
// wrong in form the two differ, since what the form may do weighs less in the
// likelihood. Steps are those of form_error.hpp, taken while it grows.
#pragma once

#include "updating/fit/fitter.hpp"

namespace tapfit::updating {

/// What likelihoods that are compared share.
struct Judgement {
  double data = 1.0;   ///< independent data in what is left
  double noise = 0.0;  ///< relative error from the hits' scatter
};

/// @return the fit with the parameters that are likeliest, their covariance and
///   what they leave as they were at the least residual
[[nodiscard]] Fit likeliest_fit(const Fit& fit,
                                const Fitter& fitter,
                                const Judgement& judgement);

}  // namespace tapfit::updating
