// Mistakes made in a clean test one at a time: of the sheet, of the front end,
// of the files.
#pragma once

#include "tests/updating/support/generated_bundle.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tapfit::updating::testing {

/// One mistake.
struct Mistake {
  std::string name;
  /// Some finding that is no note must hold all of these words; one "|" parts
  /// alternatives.
  std::vector<std::string> words;
  /// @param size 0 just visible ... 1 gross
  std::function<void(SheetAndRecords&, const PlainOptions&, double size)> make;
};

[[nodiscard]] const std::vector<Mistake>& mistakes();

}  // namespace tapfit::updating::testing
