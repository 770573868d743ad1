// What else than the data holds a fit where it ended: a narrow prior, a bound,
// lambda, too few steps. An error that is left may be theirs.
#pragma once

#include "acquisition/test_bundle.hpp"
#include "updating/diagnosis.hpp"
#include "updating/structure/deck.hpp"
#include "updating/update_record.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// @param parameters Session::model_parameters()
/// @return one clause for each property two standard deviations of its prior
///   or more from the deck's value, each parameter at a bound, and each fit
///   that did not arrive
[[nodiscard]] std::vector<std::string> held_back(
    const structure::Deck& deck,
    const acquisition::TestBundle& bundle,
    const std::vector<updating::Estimate>& parameters,
    const std::vector<updating::UpdateRecord>& records);

}  // namespace tapfit::tui
