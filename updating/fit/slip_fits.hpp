// The deck as it is and with each of its likely slips put right, all else being
// as it is: what fits of the uncertain properties leave of the measurement. To
// exchange two numbers is no small change, hence a base for each; on the deck's
// own mesh, where that costs little.
#pragma once

#include "updating/fit/fitter.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

struct SlipFit {
  std::string edit;           ///< see CardSlip
  std::vector<int> elements;  ///< with the card, ascending
  double error = 0.0;         ///< relative FRF error that is left
  double log_likelihood = 0.0;
};

struct SlipFits {
  SlipFit plain;  ///< of the deck as it is
  std::vector<SlipFit> slips;
};

/// @param fitter of the deck; its own effects are not asked for
/// @return without slips where the deck has none that is likely
[[nodiscard]] SlipFits fit_slips(const Fitter& fitter,
                                 const Progress& progress);

}  // namespace tapfit::updating
