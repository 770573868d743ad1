// The list of the Diagnose screen: every candidate with its probability, place,
// error and size; numbered, those that make up the verdict.
#pragma once

#include "tui/widgets/table.hpp"
#include "updating/diagnosis/diagnosis.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// @param tagged marked with a star
/// @param width of the screen [cells]; a wide one has columns more
[[nodiscard]] Table candidate_table(
    const updating::Diagnosis& d,
    const std::vector<updating::EffectRef>& tagged,
    int width,
    bool ascii);

/// Those that are in the list, in its order.
[[nodiscard]] std::vector<updating::EffectRef> tagged_of(
    const updating::Diagnosis& d,
    const std::vector<updating::EffectRef>& tagged);

/// The error on data left out of the fit; "–" where it was not tried.
[[nodiscard]] std::string left_out(const updating::Candidate& c);

/// Whether the list has a column for it.
[[nodiscard]] bool is_wide(int width);

}  // namespace tapfit::tui
