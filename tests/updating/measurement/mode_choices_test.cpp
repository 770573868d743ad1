#include "updating/measurement/mode_choices.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace tapfit::updating {
namespace {

using What = modal::PoleEdit::What;

TEST(ModeChoices, APairTakesThePlaceOfThoseItContradicts) {
  ModeChoices choices;
  choices = with_pair(choices, {20.0, 2});
  choices = with_pair(choices, {30.0, 3});
  choices = with_pair(choices, {20.0005, 4});  // the same measured mode
  choices = with_pair(choices, {40.0, 3});     // the same mode of the model
  const std::vector<PairByHand> expected{{20.0005, 4}, {40.0, 3}};
  EXPECT_EQ(choices.pairs, expected);
  // Two measured modes may both be without a partner.
  choices = with_pair(choices, {50.0, -1});
  choices = with_pair(choices, {60.0, -1});
  EXPECT_EQ(choices.pairs.size(), 4U);
}

/// A portal of bars, nothing hidden: modes at 6.92, 18.45, 44.90, 61.48 Hz.
class ChosenModes : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_.emplace();
    VirtualBundleSpec spec;
    spec.structure = "portal";
    spec.seed = 5;
    spec.points = 4;
    spec.hits = 3;
    make_virtual_bundle(spec, folder_->path() / "test");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static inline std::optional<tapfit::testing::TemporaryFolder> folder_;
};

TEST_F(ChosenModes, AreUsedByAllThatFollowsAndCanBeUndone) {
  Session session(folder_->path() / "test");
  const std::size_t all = session.modes().modes.size();
  ASSERT_GE(all, 6U);
  const double error = session.base_comparison().error;
  ASSERT_EQ(session.base_comparison().pairs.size(), all);

  ModeChoices choices;
  choices.edits = {{What::Drop, 18.4}};
  session.choose_modes(choices);
  EXPECT_EQ(session.modes().modes.size(), all - 1);
  EXPECT_EQ(session.base_comparison().pairs.size(), all - 1);
  EXPECT_NEAR(session.base_comparison().pairs[1].model_hz, 44.95, 0.01);
  // The model's damping is that of the modes measured, one fewer now.
  EXPECT_NE(session.base_comparison().error, error);

  choices.edits.push_back({What::Drop, 18.4});  // it is gone
  EXPECT_THROW(session.choose_modes(choices), InputError);
  EXPECT_EQ(session.modes().modes.size(), all - 1) << "all stays as it was";
  EXPECT_EQ(session.mode_choices().edits.size(), 1U);

  EXPECT_TRUE(session.undo_modes());
  EXPECT_EQ(session.modes().modes.size(), all);
  EXPECT_EQ(session.base_comparison().error, error);
  EXPECT_FALSE(session.undo_modes());
  EXPECT_TRUE(session.redo_modes());
  EXPECT_EQ(session.modes().modes.size(), all - 1);
  EXPECT_FALSE(session.redo_modes());
}

TEST_F(ChosenModes, PairsByHandStandAndSurviveAnEditOfTheModes) {
  Session session(folder_->path() / "test");
  const auto& modes = session.modes().modes;
  const double second = modes[1].frequency_hz;
  const double third = modes[2].frequency_hz;
  ModeChoices choices = with_pair({}, {third, 0});
  choices = with_pair(choices, {second, -1});
  session.choose_modes(choices);
  for (const bool edited : {false, true}) {
    const auto& pairs = session.base_comparison().pairs;
    for (const ModePair& pair : pairs) {
      EXPECT_GT(std::abs(pair.measured_hz - second), 1.0) << "has no partner";
      const bool swapped = std::abs(pair.measured_hz - third) < 1.0;
      EXPECT_EQ(pair.by_hand, swapped);
      if (swapped) {
        EXPECT_EQ(pair.model, 0);
        EXPECT_LT(pair.mac, 0.9);
      } else {
        EXPECT_NE(pair.model, 0);
      }
    }
    if (edited) break;
    // Numbers of the measured modes change, the pairs do not.
    choices.edits = {{What::Drop, modes[0].frequency_hz}};
    session.choose_modes(choices);
  }
  choices.pairs = {{1000.0, 2}, {third, 99}};
  session.choose_modes(choices);
  const std::vector<std::string>& notes = session.base_comparison().pair_notes;
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_NE(notes[0].find("no measured mode is within 2 %"), std::string::npos);
  EXPECT_NE(notes[1].find("no such mode"), std::string::npos);
}

TEST_F(ChosenModes, AreTakenUpFromASavedSession) {
  SavedSession saved;
  saved.modes.band_hz = {10.0, 100.0};
  saved.modes.edits = {{What::Drop, 44.9}};
  Session session(folder_->path() / "test");
  session.take_up(saved);
  for (const modal::Mode& mode : session.modes().modes) {
    EXPECT_GT(mode.frequency_hz, 10.0);
    EXPECT_LT(mode.frequency_hz, 100.0);
    EXPECT_GT(std::abs(mode.frequency_hz - 44.9), 1.0);
  }
  EXPECT_EQ(session.saved().modes, saved.modes);
}

// The model's own modes are one to one in its mass at measured points.
TEST_F(ChosenModes, WeightedMacTellsModesApartThatPlainMacConfuses) {
  Session session(folder_->path() / "test");
  const Comparison& c = session.base_comparison();
  ASSERT_EQ(c.weighted_mac.rows(), c.mac.rows());
  ASSERT_EQ(c.weighted_mac.cols(), c.mac.cols());
  for (const ModePair& pair : c.pairs) {
    EXPECT_GT(pair.weighted_mac, 0.98);
    EXPECT_EQ(pair.weighted_mac, c.weighted_mac(pair.measured, pair.model));
  }
}

TEST(PairsByIndex, KeepsWhatContradictsNothingAndNamesTheRest) {
  const Eigen::Vector3d measured(10.0, 20.0, 30.0);
  std::vector<std::string> notes;
  const std::vector<modal::Pair> pairs =
      pairs_by_index({{20.3, 4},   // the second, 1.5 % off
                      {25.0, 0},   // none is near
                      {30.0, 9},   // the model has nine, from 0
                      {10.0, 4},   // taken by the second
                      {19.9, -1},  // the second is paired
                      {10.0, -1}},
                     measured,
                     9,
                     notes);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].measured, 1);
  EXPECT_EQ(pairs[0].model, 4);
  EXPECT_EQ(pairs[1].measured, 0);
  EXPECT_EQ(pairs[1].model, -1);
  EXPECT_EQ(notes.size(), 4U);
}

}  // namespace
}  // namespace tapfit::updating
