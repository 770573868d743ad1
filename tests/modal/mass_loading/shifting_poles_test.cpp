// FRFs whose poles differ from one to the next without its being said.
#include "modal/identify/identify_modes.hpp"
#include "tests/modal/support/loaded_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::modal {
namespace {

// Shifts of half of the half bandwidth: a second pole follows them, and is no
// mode.
TEST(ShiftingPoles, AreOneModeEachAndSaidToDiffer) {
  const ModeSet found = identify_modes(test::one_reference(2e-3, 0.001), {});
  EXPECT_EQ(found.modes.size(), 4U);
  EXPECT_TRUE(std::ranges::any_of(found.warnings, [](const std::string& said) {
    return said.find("not quite the same in all") != std::string::npos;
  }));
}

TEST(ShiftingPoles, AreRefinedToLessThanTheDiagramsPolesLeave) {
  for (const double kg : {1e-4, 4e-4, 1e-3, 3e-3}) {
    const ModeSet found = identify_modes(test::one_reference(kg, 0.003), {});
    EXPECT_LE(found.synthesis_error, found.unrefined_error) << kg;
  }
}

}  // namespace
}  // namespace tapfit::modal
