// A list in a sentence.
#pragma once

#include <string>
#include <vector>

namespace tapfit::structure {

/// The first items with commas between, then how many more there are.
[[nodiscard]] std::string listed(const std::vector<std::string>& items,
                                 std::size_t shown = 4);

}  // namespace tapfit::structure
