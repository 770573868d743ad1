// What the Diagnose screen has to say of a candidate in words, and all of it
// where lines of the screen had no room.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// "verdict: joint"; of a verdict that nothing is missing, that in words.
[[nodiscard]] std::string verdict_words(const updating::Diagnosis& diagnosis);

/// "indistinguishable with these points from: joint line 34:35", or of what is
/// in the verdict that it is uniquely identified; else empty.
/// @param of_modes whether the test consists of modes
[[nodiscard]] std::string indistinguishable(
    const updating::Diagnosis& diagnosis,
    const updating::Candidate& candidate,
    bool of_modes);

/// What to measure to know, where the candidate is in the verdict; else empty.
[[nodiscard]] std::string next_step(const updating::Diagnosis& diagnosis,
                                    const updating::Candidate& candidate);

/// Every parameter with its standard deviation and interval.
[[nodiscard]] std::string all_sizes(const updating::Candidate& candidate);

/// Verdict, how it was compared, every warning, and all about the candidate;
/// in lines of at most `width` cells.
[[nodiscard]] std::vector<std::string> details_of(
    const updating::Diagnosis& diagnosis,
    const updating::Candidate& candidate,
    int width,
    bool of_modes = false);

/// How firm the verdict is: a sentence, and a line for each thing that was
/// changed; while that is not known, that it is worked out.
[[nodiscard]] std::vector<std::string> firmness_lines(
    const updating::Diagnosis& diagnosis, int width);

}  // namespace tapfit::tui
