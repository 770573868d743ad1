#include "updating/comparison/effect_evidence.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

Comparison compared(double error, std::vector<double> of_frfs) {
  Comparison c;
  c.error = error;
  for (std::size_t k = 0; k < of_frfs.size(); ++k) {
    c.model_frfs.emplace_back(
        Eigen::VectorXcd::Constant(2, error + static_cast<double>(k)));
  }
  c.frf_error = std::move(of_frfs);
  return c;
}

// Of 0.9, 0.5 and 0.2 the squares fall by 0.17, 0.24 and 0.
TEST(EffectEvidence, IsShownOnTheFrfThatGainsMost) {
  const EffectEvidence found = effect_evidence(compared(0.6, {0.9, 0.5, 0.2}),
                                               compared(0.4, {0.8, 0.1, 0.2}));
  EXPECT_EQ(found.error_without, 0.6);
  EXPECT_EQ(found.error_with, 0.4);
  ASSERT_EQ(found.frf, 1U);
  EXPECT_EQ(found.frf_error_without, 0.5);
  EXPECT_EQ(found.frf_error_with, 0.1);
  EXPECT_EQ(found.without[0], 1.6);
  EXPECT_EQ(found.with[0], 1.4);
}

TEST(EffectEvidence, OfATestOfModesHasNoFrf) {
  const EffectEvidence found =
      effect_evidence(compared(0.02, {}), compared(0.01, {}));
  EXPECT_EQ(found.error_without, 0.02);
  EXPECT_FALSE(found.frf);
}

}  // namespace
}  // namespace tapfit::updating
