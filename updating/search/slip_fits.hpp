// The deck as it is and with its likely slips put right, all else being as it
// is: what fits of the uncertain properties leave of the measurement. To
// exchange two numbers is no small change. What a slip leaves is first seen
// through the base of the deck as it is (deck_through_base.hpp); on the deck's
// own mesh those worth it get bases of their own.
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/set_up/card_slips.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

struct SlipFit {
  std::string edit;           ///< see CardSlip
  std::vector<int> elements;  ///< with the card, ascending
  std::string kind;           ///< see CardSlip
  double error = 0.0;         ///< relative FRF error that is left
  double log_likelihood = 0.0;
};

struct SlipFits {
  SlipFit plain;  ///< of the deck as it is
  std::vector<SlipFit> slips;
};

/// Through the base of the deck as it is; errors are those on the widest line,
/// the most forgiving about modes that are off.
/// @param fitter of the deck; its own effects are not asked for
[[nodiscard]] SlipFits screen_slips(const Fitter& fitter,
                                    const std::vector<CardSlip>& slips,
                                    const Progress& progress);

/// In bases of their own.
[[nodiscard]] SlipFits fit_slips(const Fitter& fitter,
                                 const std::vector<CardSlip>& slips,
                                 const Progress& progress);

}  // namespace tapfit::updating
