// A hypothesis of which nothing is known but what it leaves.
#pragma once

#include "updating/search/hypothesis.hpp"

#include <cmath>

namespace tapfit::updating {

/// Without patterns of form: of N data its log likelihood is c - N log(error).
inline Hypothesis plain_hypothesis(double error) {
  Hypothesis h;
  h.fit.result.error = error;
  const FormError none{Eigen::MatrixXd(1, 0), Eigen::VectorXd(0)};
  h.fit.form = view(none, Eigen::VectorXd::Constant(1, error), {});
  h.fit.log_likelihood = -std::log(error);
  return h;
}

}  // namespace tapfit::updating
