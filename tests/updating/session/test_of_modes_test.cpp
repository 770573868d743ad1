// Tests that consist of modes, from the file to the comparison.
#include "updating/session/test_of_modes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/clamped_beam.hpp"
#include "tests/updating/support/modal_bundle.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tapfit::updating {
namespace {

using tapfit::testing::TemporaryFolder;
using testing::beam_points;
using testing::beam_text;
using testing::clamped_beam;

std::string said(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(TestOfModes, AClampedBeamIsComparedWithItsClosedForm) {
  const TemporaryFolder folder;
  testing::write_modal_bundle(folder,
                              beam_text(),
                              clamped_beam(beam_points()),
                              beam_points(),
                              {0.02, 0.1});
  Session session(folder.path());
  const Comparison& c = session.base_comparison();
  ASSERT_EQ(c.pairs.size(), 5U);
  for (const ModePair& pair : c.pairs) {
    // Shear and rotary inertia, which the closed form has not, lower the fifth
    // mode by (6 mm / 1 m)^2 / 12 times some hundred: below 0.2 %.
    EXPECT_LT(std::abs(pair.error_percent), 0.25) << pair.measured_hz;
    EXPECT_GT(pair.mac, 0.9999);
    EXPECT_TRUE(pair.has_shape);
  }
  EXPECT_LT(c.error, 2e-3);
  EXPECT_TRUE(c.frf_error.empty());
  EXPECT_TRUE(session.frfs().frfs.empty());
}

TEST(TestOfModes, FrequenciesAloneArePairedToo) {
  const TemporaryFolder folder;
  testing::write_modal_bundle(
      folder, beam_text(), clamped_beam({}), {}, {0.02, 0.0});
  Session session(folder.path());
  const Comparison& c = session.base_comparison();
  ASSERT_EQ(c.pairs.size(), 5U);
  EXPECT_FALSE(c.pairs[0].has_shape);
  EXPECT_LT(std::abs(c.pairs[4].error_percent), 0.25);
}

TEST(TestOfModes, OneOrTwoValuesOfAShapeAreNoEvidence) {
  for (const std::size_t values : {1U, 2U, 3U}) {
    const std::vector<Dof> all = beam_points();
    const std::vector<Dof> points(all.end() - std::ptrdiff_t(values),
                                  all.end());
    const TemporaryFolder folder;
    testing::write_modal_bundle(
        folder, beam_text(), clamped_beam(points), points, {0.02, 0.1});
    Session session(folder.path());
    const Comparison& c = session.base_comparison();
    ASSERT_FALSE(c.pairs.empty());
    EXPECT_EQ(c.pairs[0].has_shape, values == 3) << values;
    const bool said =
        std::ranges::any_of(c.pair_notes, [](const std::string& note) {
          return note.find("no MAC") != std::string::npos;
        });
    EXPECT_EQ(said, values < 3) << values;
  }
}

TEST(TestOfModes, SaysWhatItCannotBeAskedFor) {
  const TemporaryFolder folder;
  testing::write_modal_bundle(
      folder, beam_text(), clamped_beam(beam_points()), beam_points(), {});
  Session session(folder.path());
  EXPECT_NE(said([&] { (void)session.hits(); }).find("no recordings"),
            std::string::npos);
  EXPECT_NE(said([&] {
              check_shown_in_modes({{"dashpot", {}}});
            }).find("dashpot"),
            std::string::npos);
  EXPECT_NE(said([&] {
              check_shown_in_modes({{"channel-gain", {}}});
            }).find("channel-gain"),
            std::string::npos);
  EXPECT_NO_THROW(check_shown_in_modes(
      {{"added-mass", {}}, {"soft-support", {}}, {"joint", {}}}));
  UpdateChoice choice;
  choice.l_curve = true;
  EXPECT_FALSE(said([&] { session.set_update(choice); }).empty());
}

TEST(TestOfModes, ASessionSavedWithWhatModesDoNotTellIsRefused) {
  const TemporaryFolder folder;
  testing::write_modal_bundle(
      folder, beam_text(), clamped_beam(beam_points()), beam_points(), {});
  Session session(folder.path());
  SavedSession saved;
  saved.effects.resize(1);
  saved.effects[0].ref.effect = "dashpot";
  saved.effects[0].ref.where.node = 9;
  saved.effects[0].on = false;
  EXPECT_NE(said([&] { session.take_up(saved); }).find("dashpot"),
            std::string::npos);
  SavedSession undone;
  undone.undone.resize(1);
  undone.undone[0].added = {saved.effects[0].ref};
  EXPECT_NE(said([&] { session.take_up(undone); }).find("saved session"),
            std::string::npos);
  EXPECT_TRUE(session.effects().empty());
  saved.effects[0].ref.effect = "added-mass";
  session.take_up(saved);
  EXPECT_EQ(session.effects().size(), 1U);
}

TEST(TestOfModes, APointThatTheDeckHasNotIsNamed) {
  const TemporaryFolder folder;
  std::vector<Dof> points = beam_points();
  points.back().node = 99;
  testing::write_modal_bundle(
      folder, beam_text(), clamped_beam(beam_points()), points, {});
  Session session(folder.path());
  const std::string text = said([&] { (void)session.deck(); });
  EXPECT_NE(text.find("99"), std::string::npos) << text;
  EXPECT_NE(text.find("modes.csv"), std::string::npos) << text;
}

TEST(TestOfModes, ComplexShapesAreNamedAndSoIsWhatHasNoScatter) {
  const TemporaryFolder folder;
  testing::write_modal_bundle(
      folder, beam_text(), clamped_beam(beam_points()), beam_points(), {});
  folder.write("modes.csv",
               "frequency_hz,frequency_sd_hz,9Z+ re,9Z+ im,13Z+ re,13Z+ im,"
               "21Z+ re,21Z+ im\n"
               "5.0,0.01,0.2,0.0,0.5,0.0,1.0,0.0\n"
               "31.0,0.0,0.5,0.5,0.4,-0.4,-1.0,0.0\n");
  Session session(folder.path());
  const std::vector<std::string>& warnings = session.modes().warnings;
  const auto about = [&warnings](const std::string& words) {
    return std::ranges::count_if(warnings, [&](const std::string& warning) {
      return warning.find(words) != std::string::npos;
    });
  };
  EXPECT_EQ(about("do not move in phase"), 1);
  EXPECT_EQ(about("the mode at 31 Hz"), 1);
  EXPECT_EQ(about("1 of 2 frequencies came without"), 1);
  // A stated scatter of zero cannot be: the test's 0.2 % is taken.
  EXPECT_DOUBLE_EQ(session.modes().modes[1].frequency_sd_hz, 0.002 * 31.0);
  EXPECT_DOUBLE_EQ(session.modes().modes[0].frequency_sd_hz, 0.01);
}

TEST(TestOfModes, AModeThatTheModelLacksIsNamedAndFittedToNothing) {
  const TemporaryFolder folder;
  testing::TrueModes truth = clamped_beam(beam_points());
  // At 60 Hz the shape of the first, at 5 Hz: like those near it by a MAC of
  // 0.15 at the most.
  truth.hz.insert(truth.hz.begin() + 2, 60.0);
  Eigen::MatrixXd shape(truth.shape.rows(), 6);
  shape << truth.shape.leftCols(2), truth.shape.col(0),
      truth.shape.rightCols(3);
  truth.shape = shape;
  testing::write_modal_bundle(
      folder, beam_text(), truth, beam_points(), {0.02, 0.1});
  Session session(folder.path());
  const Comparison& c = session.base_comparison();
  EXPECT_EQ(c.pairs.size(), 5U);
  EXPECT_LT(c.error, 2e-3);
  const std::vector<std::string> warnings = session.model_warnings();
  EXPECT_EQ(std::ranges::count_if(warnings,
                                  [](const std::string& warning) {
                                    return warning.find("left out of fits") !=
                                           std::string::npos;
                                  }),
            1);
}

TEST(TestOfModes, OfOnePointTheFrequenciesAloneCount) {
  const TemporaryFolder folder;
  const std::vector<Dof> tip{{21, 3, 1}};
  testing::write_modal_bundle(
      folder, beam_text(), clamped_beam(tip), tip, {0.02, 0.1});
  Session session(folder.path());
  const Comparison& c = session.base_comparison();
  ASSERT_EQ(c.pairs.size(), 5U);
  for (const ModePair& pair : c.pairs) {
    EXPECT_FALSE(pair.has_shape) << pair.measured_hz;
    EXPECT_LT(std::abs(pair.error_percent), 0.25) << pair.measured_hz;
  }
}

TEST(TestOfModes, RigidModesAndThoseOutsideTheBandAreLeftOut) {
  const TemporaryFolder folder;
  testing::TrueModes truth = clamped_beam(beam_points());
  truth.hz[0] = 0.0;
  testing::write_modal_bundle(folder,
                              beam_text(),
                              truth,
                              beam_points(),
                              {},
                              R"(, "band_hz": [1, 200])");
  Session session(folder.path());
  const modal::ModeSet& modes = session.modes();
  ASSERT_EQ(modes.modes.size(), 3U);  // the fifth is at 285 Hz
  EXPECT_GE(modes.warnings.size(), 2U);
}

}  // namespace
}  // namespace tapfit::updating
