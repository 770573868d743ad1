// How strongly data speak for one explanation over another.
//
//   ln p(data | model) ~ ln p(r) - (k / 2) ln N - ln(places)
//                        - sum ((theta - mean) / sd)^2 / 2
//
// the Bayesian information criterion, with p(r) of form_error.hpp: variance and
// form error of the deck are unknown, the one at its likeliest, the other
// summed over; and the price of having searched many places. Source: G.
// Schwarz, "Estimating the dimension of a model", Annals of Statistics 6, 1978;
// R. E. Kass, A. E. Raftery, "Bayes factors", JASA 90, 1995.
#pragma once

#include "updating/fit/fitter.hpp"

#include <vector>

namespace tapfit::updating {

/// How likely the data are by one explanation.
struct Evidence {
  double log = 0.0;
  /// The same by a form of the deck that is no better than usual (see
  /// form_error.hpp): its difference tells whether anything is missing.
  double log_if_usual = 0.0;
};

/// @param fit all there is to fit
/// @param parameters the effect's own, beyond those every model has
/// @param places places it was searched at
/// @param data from independent_data()
/// @param noise relative error that the scatter over hits alone would give
[[nodiscard]] Evidence evidence(const Fit& fit,
                                double parameters,
                                double places,
                                double data,
                                double noise);

/// Of an effect over leaving it out. What a usual form of the deck may do is no
/// reason to add anything, unless the effect does next to all of it: then the
/// deck is better than usual.
/// @param left of the error without it, the share that is left with it
[[nodiscard]] double log_gain(const Evidence& with,
                              const Evidence& without,
                              double left);

/// Probabilities from log evidences, which may be far apart; sum 1.
[[nodiscard]] std::vector<double> probabilities(
    const std::vector<double>& log_evidences);

}  // namespace tapfit::updating
