#include "tui/report/update_output.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

// Two stages of one step each, two parameters.
updating::UpdateRecord example() {
  updating::UpdateRecord record;
  record.added = "added-mass";
  record.where.node = 7;
  record.lines = "some lines";
  record.converged = false;
  record.message = "not converged in 30 steps";
  record.parameters = {"E:1", "added-mass mass_kg"};
  const Eigen::Vector2d start(7e10, 0.1);
  const Eigen::Vector2d after(7.1e10, 0.2);
  record.steps = {{0, 0.9, 0.0, 1e-3, start},
                  {0, 0.5, 0.3, 2e-4, after},
                  {1, 0.6, 0.0, 1e-3, after},
                  {1, 0.25, 0.1, 2e-4, after}};
  record.identifiability.singular_values = Eigen::Vector2d(1.2, 0.4);
  record.confounded = {{"E:1", "rho:1"}, {"A:2"}};
  record.correlation = Eigen::Matrix2d{{1.0, -0.75}, {-0.75, 1.0}};
  updating::LCurve curve;
  curve.lambda = Eigen::Vector3d(0.01, 0.1, 1.0);
  curve.residual_norm = Eigen::Vector3d(2.0, 2.1, 5.0);
  curve.solution_norm = Eigen::Vector3d(9.0, 0.8, 0.1);
  curve.curvature = Eigen::Vector3d(0.0, 3.0, 0.0);
  curve.corner = 1;
  record.l_curve = curve;
  return record;
}

TEST(UpdateOutput, TextShowsStepsReasonCorrelationAndCorner) {
  EXPECT_EQ(updates_text({example()}),
            "\nOn some lines\n"
            "  identified            steps  residual from      to\n"
            "  added-mass at node 7      2         60.0 %  25.0 %  not "
            "converged in 30 "
            "steps\n"
            "  note: the data alone do not tell apart E (MAT1 1), rho "
            "(material 1)\n"
            "  note: the data say nothing of A (property 2)\n"
            "\n"
            "  correlation            1     2\n"
            "  1 E (MAT1 1)        1.00\n"
            "  2 added-mass mass  -0.75  1.00\n"
            "\n"
            "  lambda  |S x - d|  |x|  L-curve, first step\n"
            "    0.01          2    9\n"
            "     0.1        2.1  0.8  corner\n"
            "       1          5  0.1\n"
            "\n");
  EXPECT_EQ(updates_text({}), "");
  updating::UpdateRecord damped = example();
  damped.lines =
      "136 lines from 1 to 55 Hz on s = sigma + j omega, sigma = 0.03 omega "
      "and at least 0.188 1/s";
  EXPECT_TRUE(updates_text({damped}).starts_with(
      "\nEvaluated at 136 frequencies, 1–55 Hz, with 3 % added damping\n"));
}

TEST(UpdateOutput, JsonHoldsEveryStepForPlotting) {
  const nlohmann::ordered_json json = updates_json({example()});
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["where"]["node"], 7);
  EXPECT_EQ(json[0]["converged"], false);
  ASSERT_EQ(json[0]["iterations"].size(), 4U);
  const auto& step = json[0]["iterations"][1];
  EXPECT_EQ(step["stage"], 0);
  EXPECT_EQ(step["error"], 0.5);
  EXPECT_EQ(step["step"], 0.3);
  EXPECT_EQ(step["lambda"], 2e-4);
  EXPECT_EQ(step["parameters"]["added-mass mass_kg"], 0.2);
  EXPECT_EQ(json[0]["l_curve"]["corner_lambda"], 0.1);
  EXPECT_EQ(json[0]["identifiability"]["not_told_apart"][1][0], "A:2");
  EXPECT_EQ(json[0]["correlation"][0][1], -0.75);
  updating::UpdateRecord plain = example();
  plain.l_curve.reset();
  EXPECT_TRUE(updates_json({plain})[0]["l_curve"].is_null());
}

}  // namespace
}  // namespace tapfit::tui
