// What somebody added to the model of a practice case by hand, as a diagnosis,
// so that it is judged by the same rules.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <vector>

namespace tapfit::updating {

/// @param ladder of a session: the base, perhaps what is uncertain, then one
///   rung per effect
/// @param floor of the error, as the comparison with all of it has it
/// @return with the effects joined as verdict, "none" where there is none
[[nodiscard]] Diagnosis as_diagnosis(const std::vector<Rung>& ladder,
                                     double floor);

}  // namespace tapfit::updating
