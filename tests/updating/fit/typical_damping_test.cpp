#include "updating/fit/typical_damping.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;

struct FittedMode {
  double zeta = 0.01;
  double share = 1.0;  ///< of its prior's variance that the data took off
};

constexpr double assumed = 0.013;  // of the higher modes

// A fit of two properties and these modes. The properties' own entries would
// make all of them unseen if they were taken for the modes'.
UpdateResult fit_of(const std::vector<FittedMode>& modes) {
  constexpr Index properties = 2;
  constexpr double sd = 0.5;
  const auto n = static_cast<Index>(modes.size());
  UpdateResult result;
  result.state.factor.assign(properties, 1.0);
  result.state.zeta_other = assumed;
  result.state.zeta.resize(n);
  result.prior.sd = Eigen::VectorXd::Constant(properties + n, sd);
  result.covariance =
      sd * sd * Eigen::MatrixXd::Identity(properties + n, properties + n);
  for (Index q = 0; q < n; ++q) {
    const FittedMode& mode = modes[static_cast<std::size_t>(q)];
    result.state.zeta(q) = mode.zeta;
    result.covariance(properties + q, properties + q) *= 1.0 - mode.share;
  }
  return result;
}

// The definition of the median.
TEST(TypicalDamping, IsTheMiddleOneOfModesThatAreSeenAlike) {
  for (const double share : {1.0, 0.4}) {
    EXPECT_EQ(typical_damping(
                  fit_of({{0.03, share}, {0.005, share}, {0.008, share}})),
              0.008);
    EXPECT_EQ(typical_damping(fit_of({{0.02, share}})), 0.02);
  }
}

// That of the weighted median: half of all shares lie at or below it. Two
// modes of 0.3 do not reach half of 1.5, with one of 0.9 they do.
TEST(TypicalDamping, CountsModesByWhatTheDataSayOfThem) {
  EXPECT_EQ(typical_damping(fit_of({{0.005, 0.3}, {0.006, 0.3}, {0.009, 0.9}})),
            0.009);
  EXPECT_EQ(typical_damping(fit_of({{0.005, 0.3}, {0.006, 0.5}, {0.009, 0.7}})),
            0.006);
}

TEST(TypicalDamping, ModesThatTheDataDoNotSeeHaveNoSay) {
  std::vector<FittedMode> modes = {{0.004}, {0.006}, {0.005}};
  for (int k = 0; k < 20; ++k) modes.push_back({assumed, 0.0});
  EXPECT_EQ(typical_damping(fit_of(modes)), 0.005);
  // Nor where a linearised covariance comes out above the prior's.
  for (std::size_t k = 3; k < modes.size(); ++k) modes[k].share = -0.2;
  EXPECT_EQ(typical_damping(fit_of(modes)), 0.005);
}

// A mean over the ratios, or their logarithms, would go up by a factor of
// three and more.
TEST(TypicalDamping, ADashpotsFewHeavyModesDoNotMoveIt) {
  const std::vector<FittedMode> light = {
      {0.0048}, {0.005}, {0.0052}, {0.005}, {0.0049}, {0.0051}, {0.005}};
  EXPECT_EQ(typical_damping(fit_of(light)), 0.005);
  std::vector<FittedMode> damped = light;
  damped.insert(damped.begin() + 2, {{0.2}, {0.4}});
  EXPECT_EQ(typical_damping(fit_of(damped)), 0.005);
}

TEST(TypicalDamping, IsAsAssumedWhereNothingIsSeen) {
  EXPECT_EQ(typical_damping(fit_of({})), assumed);
  EXPECT_EQ(typical_damping(fit_of({{0.004, 0.0}, {0.006, 0.0}})), assumed);
  // What rounding leaves of nothing.
  EXPECT_EQ(typical_damping(fit_of({{0.004, 1e-9}, {0.006, 1e-9}})), assumed);
  // Before the covariance is known.
  UpdateResult early = fit_of({{0.004}, {0.006}});
  early.covariance.resize(0, 0);
  EXPECT_EQ(typical_damping(early), assumed);
}

// Without a prior all that is known of it is from the data.
TEST(TypicalDamping, TakesModesWithoutAPriorAsSeen) {
  UpdateResult result = fit_of({{0.004, 0.0}, {0.006, 0.0}, {0.009, 0.0}});
  result.prior.sd.tail(3).setConstant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(typical_damping(result), 0.006);
}

}  // namespace
}  // namespace tapfit::updating
