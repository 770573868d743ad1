#include "acquisition/foundation/nearest_word.hpp"

#include <algorithm>

namespace tapfit {

std::size_t misspellings(std::string_view one, std::string_view other) {
  // Rows of the table of distances between beginnings: the one before the last,
  // the last, and this one.
  std::vector<std::size_t> before;
  std::vector<std::size_t> last(other.size() + 1);
  std::vector<std::size_t> row(other.size() + 1);
  for (std::size_t k = 0; k <= other.size(); ++k) last[k] = k;
  for (std::size_t i = 1; i <= one.size(); ++i) {
    row[0] = i;
    for (std::size_t k = 1; k <= other.size(); ++k) {
      const bool same = one[i - 1] == other[k - 1];
      row[k] =
          std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + (same ? 0 : 1)});
      const bool exchanged = i > 1 && k > 1 && one[i - 1] == other[k - 2] &&
                             one[i - 2] == other[k - 1];
      if (exchanged) row[k] = std::min(row[k], before[k - 2] + 1);
    }
    before = last;
    last.swap(row);
  }
  return last.back();
}

std::optional<std::string> nearest_word(std::string_view written,
                                        const std::vector<std::string>& known) {
  std::optional<std::string> nearest;
  if (written.empty()) return nearest;
  std::size_t least = (written.size() + 2) / 3;
  for (const std::string& word : known) {
    const bool goes_on = word.starts_with(written);
    const std::size_t wrong = goes_on ? 1 : misspellings(written, word);
    if (wrong > least || (nearest && wrong == least)) continue;
    nearest = word;
    least = wrong;
  }
  return nearest;
}

std::string did_you_mean(std::string_view written,
                         const std::vector<std::string>& known) {
  const std::optional<std::string> meant = nearest_word(written, known);
  return meant ? "did you mean " + *meant + "? " : std::string();
}

}  // namespace tapfit
