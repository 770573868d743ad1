#include "updating/comparison/form_share.hpp"

#include "acquisition/foundation/seeded_random.hpp"
#include "tests/updating/support/plate_experiment.hpp"
#include "updating/frf_model/form_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using acquisition::SeededRandom;
using Eigen::MatrixXd;

MatrixXd gaussian(SeededRandom& random, Eigen::Index rows, Eigen::Index cols) {
  MatrixXd values(rows, cols);
  for (double& value : values.reshaped()) value = random.normal();
  return values;
}

// What a fit leaves where modal stiffnesses are off by tau (relative, twice a
// frequency) and hits scatter by a tenth of that.
class FormShares : public ::testing::Test {
 protected:
  [[nodiscard]] FormShare of(double tau) const {
    constexpr Eigen::Index rows = 400;
    constexpr Eigen::Index patterns = 20;
    SeededRandom random(11, "form share");
    const MatrixXd F =
        10.0 / std::sqrt(1.0 * rows) * gaussian(random, rows, patterns);
    const Eigen::VectorXd r =
        F * (tau * gaussian(random, patterns, 1)) +
        tau / std::sqrt(1.0 * rows) * gaussian(random, rows, 1);
    Fit fit;
    fit.result.residual = r;
    fit.result.error = r.norm();
    fit.form = view({F, Eigen::VectorXd::Zero(patterns)}, r, {});
    return form_share(fit, test_.fitter().target(), 0.5 * tau);
  }
  PlateExperiment test_{{}, 0.01, 3};
};

TEST_F(FormShares, AreUsualUpToACarefulDecks) {
  const FormShare small = of(0.003);  // 0.15 % in frequency
  EXPECT_GT(small.error, 0.0);
  EXPECT_DOUBLE_EQ(small.usual, small.error);
}

// What is far off is missing rather than wrong in form: the form's share is
// what careful decks are off by, three times what is usual.
TEST_F(FormShares, AreInPartBeyondTheMostOfCarefulDecks) {
  const FormShare within = of(0.012);  // 0.6 %, twice what is usual
  // Twenty patterns tell tau to 16 %; the prior and the grid of tau add to
  // that.
  EXPECT_NEAR(within.usual / within.error, 0.5, 0.2);
  const FormShare large = of(0.03);  // 1.5 %, five times
  EXPECT_NEAR(large.usual / large.error, 1.0 / 3.0, 1e-9);
  EXPECT_LT(large.error / 0.03, 0.8 * within.error / 0.012);
}

// More than 2 % no deck's form is believed to be off by; what is usual stands.
TEST_F(FormShares, OfTooMuchAreOnlyWhatIsUsual) {
  const FormShare wrong = of(0.1);
  EXPECT_EQ(wrong.error, 0.0);
  EXPECT_GT(wrong.usual, 0.0);
  EXPECT_LT(wrong.usual, 0.15 * wrong.left);
}

}  // namespace
}  // namespace tapfit::updating
