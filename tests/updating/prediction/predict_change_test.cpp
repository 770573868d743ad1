// Predictions against the closed forms of a clamped beam.
#include "updating/prediction/predict_change.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/tip_loaded_beam.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using tapfit::testing::TemporaryFolder;
using testing::beam_kg;
using testing::beam_with_tip_mass;
using testing::sprung_beam_fault;
using testing::tip_mass;
using testing::write_beam;

TEST(PredictedBeam, WithoutAMassIsTheBeam) {
  const std::vector<double> hz = beam_with_tip_mass(0.0);
  const testing::TrueModes beam = testing::clamped_beam({});
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(hz[k] / beam.hz[k], 1.0, 1e-6);
  }
}

TEST(PredictedBeam, WithAMassAtItsTipIsAsInClosedForm) {
  const TemporaryFolder folder;
  write_beam(folder, 1.0, {0.02, 0.1});
  Session session(folder.path());
  const Prediction prediction = session.predict(tip_mass(0.1));
  const std::vector<double> now = beam_with_tip_mass(0.0);
  const std::vector<double> after = beam_with_tip_mass(0.1 / beam_kg);
  ASSERT_GE(prediction.modes.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    const PredictedMode& mode = prediction.modes[k];
    EXPECT_EQ(mode.measured, static_cast<int>(k));
    // Shear and rotary inertia, which the closed form has not: 0.2 %.
    EXPECT_NEAR(mode.frequency_hz.value / after[k], 1.0, 2e-3) << k;
    EXPECT_NEAR(
        mode.change_percent.value, 100.0 * (after[k] / now[k] - 1.0), 0.1)
        << k;
    EXPECT_NEAR(mode.change_hz.value,
                mode.model_after_hz - mode.model_hz,
                1e-9 * mode.model_hz);
    EXPECT_GT(mode.frequency_hz.sd, 0.0);
    EXPECT_LT(mode.frequency_hz.lo95, mode.frequency_hz.value);
    // Measured damping of 1 %, which nothing changes.
    ASSERT_TRUE(mode.damping_ratio);
    EXPECT_NEAR(mode.damping_ratio->value, 0.01, 1e-9);
  }
  EXPECT_TRUE(prediction.frfs.frfs.empty());
  EXPECT_TRUE(prediction.with.empty());
  ASSERT_EQ(prediction.change.size(), 1U);
}

// What is left uncertain by the measurement shows; nothing is claimed beyond.
TEST(PredictedBeam, IntervalsHoldAsOftenAsTheySay) {
  constexpr int draws = 16;
  constexpr double stiffer = 1.04;
  const std::vector<double> truth = beam_with_tip_mass(0.1 / beam_kg, stiffer);
  int held = 0;
  int all = 0;
  double widest = 0.0;
  for (unsigned seed = 1; seed <= draws; ++seed) {
    const TemporaryFolder folder;
    write_beam(folder, stiffer, {0.3, 2.0, seed});
    Session session(folder.path());
    const Prediction prediction = session.predict(tip_mass(0.1));
    for (const PredictedMode& mode : prediction.modes) {
      if (!mode.measured) continue;
      const double hz = truth.at(static_cast<std::size_t>(*mode.measured));
      const Estimate& f = mode.frequency_hz;
      held += f.lo95 <= hz && hz <= f.hi95 ? 1 : 0;
      widest = std::max(widest, (f.hi95 - f.lo95) / f.value);
      ++all;
    }
  }
  ASSERT_EQ(all, 5 * draws);
  // Of 80 a fair interval misses 4; those of one draw err together.
  EXPECT_GE(held, all - 10);
  // Five frequencies scatter by 0.3 %: no interval is wider than that of one
  // alone and a form off by half a percent.
  EXPECT_LT(widest, 2.0 * 1.96 * std::hypot(0.003, 0.005));
}

// Modes of a beam whose tip is held are likest to higher ones of the free beam;
// yet a spring lowers none.
TEST(PredictedBeam, HeldAtItsTipIsHigherModeByMode) {
  const TemporaryFolder folder;
  write_beam(folder, 1.0, {0.02, 0.1});
  Session session(folder.path());
  constexpr double k = 1e6;
  const Prediction prediction = session.predict(
      {parse_stated_change(fmt::format("ground-spring@21:Z={}", k))});
  ASSERT_GE(prediction.modes.size(), 4U);
  const double EI = 2.1e11 * testing::beam_inertia;
  for (std::size_t m = 0; m < 4; ++m) {
    const PredictedMode& mode = prediction.modes[m];
    EXPECT_GT(mode.model_after_hz, mode.model_hz) << m;
    if (m > 0) {
      EXPECT_GT(mode.model_after_hz, prediction.modes[m - 1].model_after_hz);
    }
    // Of b, 0.2 % below the closed form at most: shear and rotary inertia.
    const double b =
        std::sqrt(two_pi * mode.model_after_hz / std::sqrt(EI / beam_kg));
    EXPECT_LT(sprung_beam_fault(k / EI, b * (1.0 - 1e-4)) *
                  sprung_beam_fault(k / EI, b * (1.0 + 2e-3)),
              0.0)
        << m;
  }
}

TEST(PredictedBeam, RefusesWhatTheModelCannotHold) {
  const TemporaryFolder folder;
  write_beam(folder, 1.0, {0.02, 0.1});
  Session session(folder.path());
  const auto fault = [&session](const char* text) {
    try {
      (void)session.predict({parse_stated_change(text)});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(fault("added-mass@21=5").find("out of range"), std::string::npos);
  EXPECT_NE(fault("added-mass@1=0.1").find("cannot sit"), std::string::npos);
  EXPECT_NE(fault("added-mass@99=0.1").find("no grid 99"), std::string::npos);
  EXPECT_NE(fault("stiffness-loss@3=1.5").find("out of range"),
            std::string::npos);
}

// A clamped beam of which one half is softer everywhere: f' = f sqrt(0.8) where
// all of it is.
TEST(PredictedBeam, SoftenedEverywhereIsLowerByTheRoot) {
  const TemporaryFolder folder;
  write_beam(folder, 1.0, {0.02, 0.1});
  Session session(folder.path());
  std::string all = "stiffness-loss@1";
  for (int id = 2; id <= testing::beam_bars; ++id)
    all += fmt::format(":{}", id);
  const Prediction prediction =
      session.predict({parse_stated_change(all + "=0.8")});
  ASSERT_GE(prediction.modes.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    // What the mesh does to the modes is taken as it was.
    EXPECT_NEAR(prediction.modes[k].change_percent.value,
                100.0 * (std::sqrt(0.8) - 1.0),
                0.05)
        << k;
  }
}

}  // namespace
}  // namespace tapfit::updating
