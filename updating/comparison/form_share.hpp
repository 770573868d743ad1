// What of a fit's error the deck's form may explain, and how many independent
// data there are to tell: the form's share of the floor.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/residual/residual.hpp"

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

/// What of a fit's error the deck's form explains.
struct FormShare {
  double sd = 0.0;     ///< of a mode's frequency, relative
  double error = 0.0;  ///< what it explains
  double left = 0.0;   ///< and what not: all, where it would have to be off by
                       ///< more than a careful deck is, 2 % in frequency
};
/// @param data from evidence_data()
/// @param noise relative error that the scatter over hits alone would give
/// @return nothing explained for what is no fit, as the deck as it is
[[nodiscard]] FormShare form_share(const Fit& fit, double data, double noise);

}  // namespace tapfit::updating
