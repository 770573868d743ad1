// What a diagnosis found, as effects to be put into the model.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::tui {

/// At its place, with the sizes that were found.
[[nodiscard]] updating::EffectRef ref_of(const updating::Candidate& candidate);

/// All that the verdict is made of, in its order; of look-alikes the first.
/// What no linear model holds is left out.
[[nodiscard]] std::vector<updating::EffectRef> verdict_of(
    const updating::Diagnosis& diagnosis);

/// What the candidate's sizes were found with: the verdict where it is part of
/// it, else itself alone.
[[nodiscard]] std::vector<updating::EffectRef> found_with(
    const updating::Diagnosis& diagnosis, const updating::Candidate& candidate);

/// The error of the rung with so many effects. Beside theirs the ladder has
/// those of the base and of what is uncertain, first.
[[nodiscard]] double error_with(const std::vector<updating::Rung>& ladder,
                                std::size_t effects,
                                const updating::Diagnosis& diagnosis);

/// With what the diagnosis found: of the ladder where that goes on with it,
/// since a fit made anew need not end at the same last digit.
[[nodiscard]] double error_found(const std::vector<updating::Rung>& ladder,
                                 std::size_t effects,
                                 const updating::Diagnosis& diagnosis);

}  // namespace tapfit::tui
