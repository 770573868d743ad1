#include "updating/search/reach.hpp"

#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {
namespace {

// Of the logarithm of a likelihood: the rest of the way changes it by one or
// two, and what parameters and places cost by a dozen.
constexpr double out_of_reach = 15.0;

// Times the error on the wide lines of what is known: of N independent data
// that is N ln 3 of log likelihood, and of thirty of the form's patterns alone
// twice what is out of reach.
constexpr double far_behind = 3.0;

// The screening, of first order, says less than a fit over the wide lines
// leaves; where the rest has to move far it said up to twice as much, and once
// four times (1356 fits of nine tests).
constexpr double screened_high = 2.0;

}  // namespace

Reach::Reach(const Fit& current, const Fitter& fitter)
    : Reach(independent_data(fitter.target(), current.result.residual),
            noise_error(fitter.target())) {}

Hypothesis Reach::judged(Fit fit) const {
  const double likely = estimate_form(fit.form, data_, noise_).log_likelihood;
  return {std::move(fit), likely};
}

void Reach::take(const Hypothesis& of) {
  most_ = std::max(most_, of.log_likelihood);
  least_error_ = std::min(least_error_, of.fit.result.error);
}

void Reach::take_known(const Fit& fit, const Fitter& fitter) {
  take(judged(fit));
  const Target& wide = fitter.problem().targets.front();
  const Eigen::MatrixXcd H =
      fit.model->respond(fit.result.state, wide.s, false).H;
  known_wide_ = std::min(known_wide_, relative_error(wide, H));
}

double Reach::hopeless_wide_error() const {
  return std::max(far_behind, std::exp(out_of_reach / data_)) * known_wide_;
}

double Reach::hopeless_screened_error() const {
  return screened_high * hopeless_wide_error();
}

bool Reach::is_hopeless(const Hypothesis& of) const {
  return of.fit.result.error > least_error_ &&
         of.log_likelihood < most_ - out_of_reach;
}

bool Reach::holds_way(const Hypothesis& before,
                      const Hypothesis& now,
                      int steps) const {
  const double pace = now.log_likelihood - before.log_likelihood;
  return now.log_likelihood + pace * steps >= most_ - out_of_reach;
}

}  // namespace tapfit::updating
