#include "updating/fit/fit_problem.hpp"

#include "tests/updating/support/sample_plate.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

class HungPlate : public ::testing::Test {
 protected:
  [[nodiscard]] BaseBuilder builder(bool clamped) const {
    const structure::Deck deck = support::plate_deck(clamped);
    return {deck, {}, support::plate_base(bundle_, deck), Progress{}};
  }
  /// @param hz of the first mode that was measured
  [[nodiscard]] std::shared_ptr<const effects::Suspension> hung(
      double hz) const {
    modal::ModeSet modes;
    modes.modes.resize(1);
    modes.modes[0].frequency_hz = hz;
    return suspension_of(bundle_, modes, free_);
  }

  acquisition::TestBundle bundle_ = support::plate_bundle();
  BaseBuilder free_ = builder(false);
};

TEST_F(HungPlate, HangsAsIsUsualWhereOnlyElasticModesWereMeasured) {
  bundle_.modes = acquisition::ReadyModes{};
  const auto usual = hung(free_.elastic_hz());
  ASSERT_NE(usual, nullptr);
  EXPECT_DOUBLE_EQ(usual->highest_hz, 0.2 * free_.elastic_hz());
  EXPECT_EQ(usual->rigid.cols(), 6);
  EXPECT_EQ(usual->rigid.rows(), 6 * 55);
}

TEST_F(HungPlate, MeasuredRigidBodyModesAndFrfsTellByThemselves) {
  EXPECT_EQ(hung(free_.elastic_hz()), nullptr) << "FRFs have their mass line";
  bundle_.modes = acquisition::ReadyModes{};
  EXPECT_EQ(hung(0.1 * free_.elastic_hz()), nullptr);
}

TEST_F(HungPlate, HangsAsIsSaid) {
  bundle_.suspension_hz = 12.0;
  ASSERT_NE(hung(free_.elastic_hz()), nullptr);
  EXPECT_EQ(hung(free_.elastic_hz())->highest_hz, 12.0);
  EXPECT_EQ(suspension_of(bundle_, {}, builder(true)), nullptr)
      << "a clamped plate hangs on nothing";
}

}  // namespace
}  // namespace tapfit::updating
