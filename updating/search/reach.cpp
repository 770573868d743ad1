#include "updating/search/reach.hpp"

#include "updating/residual/independent_data.hpp"

#include <algorithm>

namespace tapfit::updating {
namespace {

// Of the logarithm of a likelihood: the rest of the way changes it by one or
// two, and what parameters and places cost by a dozen.
constexpr double out_of_reach = 15.0;

}  // namespace

Reach::Reach(const Fit& current, const Fitter& fitter)
    : Reach(independent_data(fitter.target(), current.result.residual),
            noise_error(fitter.target())) {}

double Reach::log_likelihood(const Fit& fit) const {
  return estimate_form(fit.form, data_, noise_).log_likelihood;
}

void Reach::take(const Fit& fit) {
  most_ = std::max(most_, log_likelihood(fit));
  least_error_ = std::min(least_error_, fit.result.error);
}

bool Reach::is_hopeless(const Fit& fit) const {
  return fit.result.error > least_error_ &&
         log_likelihood(fit) < most_ - out_of_reach;
}

bool Reach::holds_way(const Fit& before, const Fit& now, int steps) const {
  const double at = log_likelihood(now);
  const double pace = at - log_likelihood(before);
  return at + pace * steps >= most_ - out_of_reach;
}

}  // namespace tapfit::updating
