// Whether measured modes confirm a prediction.
#include "updating/prediction/confirmation.hpp"

#include "tests/updating/support/tip_loaded_beam.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

using tapfit::testing::TemporaryFolder;
using testing::beam_kg;
using testing::beam_with_tip_mass;
using testing::tip_mass;
using testing::write_beam;

/// Modes as they would be measured after the change, with their scatter.
modal::ModeSet measured_after(const Prediction& prediction,
                              const std::vector<double>& hz,
                              const std::vector<Dof>& points) {
  modal::ModeSet set;
  set.dofs = points;
  for (std::size_t k = 0; k < hz.size(); ++k) {
    modal::Mode mode;
    mode.frequency_hz = hz[k];
    mode.frequency_sd_hz = 1e-4 * hz[k];
    mode.shape.resize(std::ssize(points));
    for (Eigen::Index p = 0; p < mode.shape.size(); ++p) {
      const Dof& dof = points[static_cast<std::size_t>(p)];
      mode.shape(p) = prediction.model->row(dof.node, dof.component)
                          .dot(prediction.modes[k].phi);
    }
    set.modes.push_back(std::move(mode));
  }
  return set;
}

TEST(Confirmation, IsOfTheWorstMode) {
  const TemporaryFolder folder;
  write_beam(folder, 1.0, {0.05, 0.5});
  Session session(folder.path());
  const Prediction prediction = session.predict(tip_mass(0.1));
  ASSERT_GE(prediction.modes.size(), 5U);
  const std::vector<double> truth = beam_with_tip_mass(0.1 / beam_kg);
  const std::vector<Dof> points = testing::beam_points();
  const Confirmation right =
      confirm(prediction, measured_after(prediction, truth, points));
  EXPECT_EQ(right.finding, Finding95::Confirmed)
      << statement(right, prediction);
  ASSERT_EQ(right.modes.size(), 5U);
  EXPECT_NEAR(right.modes[2].mac, 1.0, 1e-9);
  // P(|Z| > 2.5758) = 0.05 / 5, tables of the normal distribution.
  EXPECT_NEAR(right.limit, 2.5758 / 1.96, 1e-4);

  // Twice the mass was put there.
  const std::vector<double> other = beam_with_tip_mass(0.2 / beam_kg);
  const Confirmation wrong =
      confirm(prediction, measured_after(prediction, other, points));
  EXPECT_EQ(wrong.finding, Finding95::Refuted);
  EXPECT_LT(wrong.modes[0].deviation, -1.0);
  EXPECT_EQ(statement(wrong, prediction).find("refuted"), 0U);
  // Set-ups that differ by 10 % refute next to nothing.
  const Confirmation vague =
      confirm(prediction, measured_after(prediction, other, points), 0.1);
  EXPECT_EQ(vague.finding, Finding95::Confirmed);

  const Confirmation nothing = confirm(prediction, {});
  EXPECT_EQ(nothing.finding, Finding95::Undecided);
  EXPECT_EQ(nothing.unseen.size(), prediction.modes.size());
}

TEST(Confirmation, OfFrequenciesAloneHasNoMac) {
  const TemporaryFolder folder;
  write_beam(folder, 1.0, {0.05, 0.5});
  Session session(folder.path());
  const Prediction prediction = session.predict(tip_mass(0.1));
  const std::vector<double> first = {beam_with_tip_mass(0.1 / beam_kg)[0]};
  const Confirmation found =
      confirm(prediction, measured_after(prediction, first, {}));
  ASSERT_EQ(found.modes.size(), 1U);
  EXPECT_FALSE(found.modes[0].has_shape);
  // P(|Z| > 1.96) = 0.05.
  EXPECT_NEAR(found.limit, 1.0, 1e-4);
}

}  // namespace
}  // namespace tapfit::updating
