// How strongly data speak for one explanation over another.
//
//   ln p(data | model) ~ ln p(r) - (k / 2) ln N - ln(places)
//                        - sum ((theta - mean) / sd)^2 / 2
//
// the Bayesian information criterion, with p(r) of form_error.hpp: variance and
// form error of the deck are unknown and integrated out; and the price of
// having searched many places.
// Source: G. Schwarz, "Estimating the dimension of a model", Annals of
// Statistics 6, 1978; R. E. Kass, A. E. Raftery, "Bayes factors", JASA 90,
// 1995.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/fit/residual.hpp"

#include <vector>

namespace tapfit::updating {

/// Independent real data for choosing between models.
///
/// FRFs of a structure with m modes in the band are fixed by m residues each
/// and the m frequencies that they share (damping is fitted along in every
/// model), so that more lines do not make more evidence, whatever their number.
/// Nor is the residual more than residual_data() says.
///
/// @param residual of the best explanation, as from stack()
[[nodiscard]] double evidence_data(const Target& target,
                                   const Eigen::VectorXd& residual,
                                   int modes_in_band);

/// @param fit all there is to fit
/// @param parameters the effect's own, beyond those every model has
/// @param places places it was searched at
/// @param data from evidence_data()
/// @param noise relative error that the scatter over hits alone would give
[[nodiscard]] double log_evidence(const Fit& fit,
                                  double parameters,
                                  double places,
                                  double data,
                                  double noise);

/// What of a fit's error the deck's form explains.
struct FormShare {
  double sd = 0.0;     ///< of a mode's frequency, relative
  double error = 0.0;  ///< what it explains
  double left = 0.0;   ///< and what not: all, where it would have to be off by
                       ///< more than a careful deck is, 2 % in frequency
};
[[nodiscard]] FormShare form_share(const Fit& fit, double data, double noise);

/// Probabilities from log evidences, which may be far apart; sum 1.
[[nodiscard]] std::vector<double> probabilities(
    const std::vector<double>& log_evidences);

}  // namespace tapfit::updating
