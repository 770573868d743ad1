// What mistakes of the sheet share: points, directions, channels or units in
// test.json that were not those of the test. They are put right in the sheet,
// see Effect::correct(); nothing acts on the structure.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <fmt/format.h>

namespace tapfit::effects {

class SheetMistake : public Effect {
 public:
  using Effect::Effect;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext&,
      const std::vector<double>&) const final {
    return {fmt::format("$ The sheet is at fault, not the model: {}, {}",
                        name(),
                        describe(where))};
  }
};

}  // namespace tapfit::effects
