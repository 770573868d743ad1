// Which word was meant by one that is misspelt.
//
// Source: optimal string alignment, the distance of F. J. Damerau, "A technique
// for computer detection and correction of spelling errors", Communications of
// the ACM 7(3), 1964.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit {

/// How many letters are to be put in, left out, changed or exchanged with their
/// neighbour so that one word becomes the other.
[[nodiscard]] std::size_t misspellings(std::string_view one,
                                       std::string_view other);

/// The known word that is nearest, the first of several; a word that goes on
/// where what was written ends is near, too. Empty where more than a
/// third of the letters would be wrong.
[[nodiscard]] std::optional<std::string> nearest_word(
    std::string_view written, const std::vector<std::string>& known);

/// "did you mean joint? "; empty where no word is near.
[[nodiscard]] std::string did_you_mean(std::string_view written,
                                       const std::vector<std::string>& known);

}  // namespace tapfit
