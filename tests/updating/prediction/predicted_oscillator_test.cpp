// Predictions against the closed forms of a mass on a spring.
#include "acquisition/foundation/constants.hpp"
#include "signal/files/uff58.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/prediction/predict_change.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tapfit::updating {
namespace {

using tapfit::testing::TemporaryFolder;

/// A mass of 2 kg on a spring, with a damping ratio of 1 %, seen by its FRF:
///
///   H = s^2 / (m s^2 + c s + k)
constexpr double mass_kg = 2.0;
constexpr double spring = 2.0 * 100.0 * 100.0 * 4.0;  // 200 rad/s
constexpr double ratio = 0.01;

Eigen::VectorXcd oscillator(const Eigen::VectorXcd& s,
                            double more_kg,
                            double damper) {
  const double m = mass_kg + more_kg;
  const double c = 2.0 * ratio * std::sqrt(spring * m) + damper;
  const Eigen::ArrayXcd s2 = s.array().square();
  return (s2 / (m * s2 + c * s.array() + spring)).matrix();
}

class PredictedOscillator : public ::testing::Test {
 protected:
  PredictedOscillator() { write(0.0); }

  /// @param damper of the deck, and of what was measured [N s/m]
  void write(double damper) const {
    signal::FrfSet set;
    constexpr Eigen::Index lines = 550;
    set.s.resize(lines);
    for (Eigen::Index l = 0; l < lines; ++l) {
      set.s(l) = {0.0, two_pi * (5.0 + 0.1 * static_cast<double>(l))};
    }
    signal::Frf frf;
    frf.response = frf.reference = {1, 3, 1};
    frf.H = oscillator(set.s, 0.0, damper);
    frf.coherence = Eigen::VectorXd::Ones(lines);
    frf.variance = Eigen::VectorXd::Zero(lines);
    set.frfs.push_back(frf);
    signal::write_frfs_uff(
        set, "oscillator", folder_.path() / "measured.uff", {{}, true});
    folder_.write(
        "model.bdf",
        fmt::format("BEGIN BULK\nGRID,1,,0.,0.,0.,,12456\n"
                    "CONM2,1,1,,{}\nCELAS2,2,{},1,3\n{}ENDDATA\n",
                    mass_kg,
                    spring,
                    damper > 0.0 ? fmt::format("CDAMP2,3,{},1,3\n", damper)
                                 : std::string()));
    folder_.write("test.json", R"({"tapfit": 1, "model": "model.bdf",
      "frfs": "measured.uff", "band_hz": [8, 60]})");
  }

  [[nodiscard]] Prediction predicted(const char* change) const {
    Session session(folder_.path());
    return session.predict({parse_stated_change(change)});
  }

  TemporaryFolder folder_;
};

// f' = f / sqrt(1 + m / M), the ratio kept: FRFs on every line.
TEST_F(PredictedOscillator, WithAMassIsLowerAndItsFrfAsInClosedForm) {
  const Prediction prediction = predicted("added-mass@1=0.5");
  ASSERT_EQ(prediction.modes.size(), 1U);
  const PredictedMode& mode = prediction.modes[0];
  const double hz = std::sqrt(spring / mass_kg) / two_pi;
  EXPECT_NEAR(mode.measured_hz, hz, 1e-4 * hz);
  EXPECT_NEAR(mode.model_hz, hz, 1e-6 * hz);
  EXPECT_NEAR(mode.model_after_hz, hz / std::sqrt(1.25), 1e-6 * hz);
  EXPECT_NEAR(mode.frequency_hz.value, hz / std::sqrt(1.25), 1e-4 * hz);
  EXPECT_NEAR(
      mode.change_percent.value, 100.0 * (1.0 / std::sqrt(1.25) - 1.0), 1e-4);
  ASSERT_TRUE(mode.damping_ratio);
  EXPECT_NEAR(mode.damping_ratio->value, ratio, 1e-4);
  ASSERT_EQ(prediction.frfs.frfs.size(), 1U);
  const Eigen::VectorXcd truth = oscillator(prediction.frfs.s, 0.5, 0.0);
  // The ratio is fitted: within a hundredth of itself.
  EXPECT_LT((prediction.frfs.frfs[0].H - truth).norm(), 0.01 * truth.norm());
  ASSERT_EQ(prediction.frf_changes.size(), 1U);
  EXPECT_GT(prediction.frf_changes[0].change,
            10.0 * prediction.frf_changes[0].sd);
}

// Two masses in a row, with mu = m / M and both w of the hosts alone:
//
//   (w1^2 - w^2) (w2^2 - w^2) = mu w2^2 w^2
//
// Den Hartog, "Mechanical Vibrations", section 3.2. Above its own frequency a
// host is pushed up by an absorber tuned below it.
TEST_F(PredictedOscillator, WithAnAbsorberBelowItIsPushedUp) {
  const double host = std::sqrt(spring / mass_kg);
  const double own = 0.7 * host;
  constexpr double mu = 0.05;
  const Prediction prediction = predicted(
      fmt::format("absorber@1={},{},0.001", mu * mass_kg, own / two_pi)
          .c_str());
  const double sum = host * host + own * own * (1.0 + mu);
  const double product = host * host * own * own;
  const double upper =
      std::sqrt(0.5 * sum + std::sqrt(0.25 * sum * sum - product));
  ASSERT_EQ(prediction.modes.size(), 1U);
  EXPECT_GT(upper, 1.01 * host);
  EXPECT_NEAR(prediction.modes[0].model_after_hz, upper / two_pi, 1e-6 * host);
  const double lower = std::sqrt(product) / upper;
  ASSERT_EQ(prediction.warnings.size(), 1U);
  EXPECT_NE(
      prediction.warnings[0].find(fmt::format("at {:.4g} Hz", lower / two_pi)),
      std::string::npos);
}

// zeta' = zeta + c / (2 M omega).
TEST_F(PredictedOscillator, WithADamperHasItsRatioOnTop) {
  const Prediction prediction = predicted("dashpot@1=4");
  ASSERT_EQ(prediction.modes.size(), 1U);
  const PredictedMode& mode = prediction.modes[0];
  ASSERT_TRUE(mode.damping_now && mode.damping_ratio);
  EXPECT_NEAR(*mode.damping_now, ratio, 1e-4);
  EXPECT_NEAR(mode.damping_ratio->value - *mode.damping_now,
              4.0 / (2.0 * mass_kg * 200.0),
              1e-6);
  EXPECT_NEAR(mode.change_hz.value, 0.0, 1e-6);
  const Eigen::VectorXcd truth = oscillator(prediction.frfs.s, 0.0, 4.0);
  EXPECT_LT((prediction.frfs.frfs[0].H - truth).norm(), 0.01 * truth.norm());
}

// What the deck's own damper takes falls with the mass; the rest stays:
// zeta' = zeta_own + c / (2 M' omega').
TEST_F(PredictedOscillator, WithADamperInTheDeckKeepsItsOwnRatio) {
  write(4.0);
  const Prediction prediction = predicted("added-mass@1=0.5");
  ASSERT_EQ(prediction.modes.size(), 1U);
  const PredictedMode& mode = prediction.modes[0];
  ASSERT_TRUE(mode.damping_now && mode.damping_ratio);
  const double after = std::sqrt(spring * (mass_kg + 0.5));
  EXPECT_NEAR(*mode.damping_now,
              ratio + 4.0 / (2.0 * std::sqrt(spring * mass_kg)),
              2e-4);
  EXPECT_NEAR(mode.damping_ratio->value, ratio + 4.0 / (2.0 * after), 2e-4);
}

}  // namespace
}  // namespace tapfit::updating
