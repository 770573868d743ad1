#include "updating/diagnosis/candidate.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

Candidate leaves(const char* effect, double error) {
  Candidate c;
  c.effect = effect;
  c.error = error;
  return c;
}

// Told as soon as it is nearly there, and once more at its end.
TEST(Candidate, TakesItsOwnPlaceAmongWhatWasTried) {
  Diagnosis d = with_tried(nullptr, leaves("joint", 0.3));
  d = with_tried(&d, leaves("dashpot", 0.2));
  EXPECT_EQ(d.candidates.front().effect, "dashpot");
  d = with_tried(&d, leaves("joint", 0.1));
  ASSERT_EQ(d.candidates.size(), 2U);
  EXPECT_EQ(d.candidates.front().effect, "joint");
  EXPECT_EQ(d.error_best, 0.1);
}

}  // namespace
}  // namespace tapfit::updating
