#include "updating/fit/plain_updater.hpp"

#include "updating/studies/property_study.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class PlainUpdaterTest : public ::testing::Test {
 protected:
  [[nodiscard]] PlainResult run(const VectorXd& lines_hz,
                                const PlainOptions& options) const {
    const Target target = make_target(study_.exact(truth_, lines_at(lines_hz)));
    return plain_update(
        model_, target, study_.state(model_, study_.nominal()), options);
  }

  const PropertyStudy study_{TAPFIT_SOURCE_DIR "/recordings/paper-truss",
                             {{4, 2, 1}, {10, 2, 1}},
                             1e4};
  const FrfModel model_{study_.model_at(study_.nominal())};
  const std::vector<double> truth_ = {1.02, 1.03, 0.98, 1.04, 0.97};
};

TEST_F(PlainUpdaterTest, FindsTheTruthWithoutNoise) {
  PlainOptions options;
  options.max_iterations = 40;
  options.rule = PeakRule{};
  options.measured_hz = study_.frequencies_hz(truth_, 7);
  const PlainResult result = run(even_lines(500.0, 1.0), options);
  EXPECT_TRUE(result.converged) << result.message;
  for (std::size_t k = 0; k < truth_.size(); ++k) {
    // Steps of regularised solutions shorten by a constant share: the error
    // left is a few times the last step, 1e-6.
    EXPECT_NEAR(result.state.factor[k], truth_[k], 1e-5);
  }
  EXPECT_LT(result.misfit(result.misfit.size() - 1), 1e-4 * result.misfit(0));
}

TEST_F(PlainUpdaterTest, FixedLambdaIsTaken) {
  PlainOptions options;
  options.max_iterations = 1;
  options.lambda = 1e6;  // so large that nothing moves
  const PlainResult result = run(even_lines(60.0, 5.0), options);
  EXPECT_LT((result.history.row(1) - result.history.row(0)).norm(), 1e-6);
}

TEST_F(PlainUpdaterTest, SaysThatNoLineIsLeft) {
  PlainOptions options;
  options.rule = PeakRule{1000.0, 0.0};
  options.measured_hz = study_.frequencies_hz(truth_, 7);
  const PlainResult result = run(even_lines(500.0, 10.0), options);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.message, "no line is left to compare");
  EXPECT_EQ(result.state.factor, study_.nominal());
}

TEST_F(PlainUpdaterTest, DivergesWithAMessageWhereLinesLieAtResonances) {
  PlainOptions options;
  options.lambda = 0.0;
  VectorXd lines(8);
  const VectorXd peaks = study_.frequencies_hz(truth_, 7);
  lines << peaks.array() - 0.02, 440.0;
  const PlainResult result = run(lines, options);
  EXPECT_FALSE(result.converged);
  EXPECT_FALSE(result.message.empty());
  for (const double f : result.state.factor) EXPECT_GT(f, 0.0);
}

}  // namespace
}  // namespace tapfit::updating
