// Predictions against closed forms: masses on a clamped beam and on a single
// mass, a damper on that.
#include "updating/prediction/predict_change.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "signal/files/uff58.hpp"
#include "tests/updating/support/clamped_beam.hpp"
#include "updating/prediction/confirmation.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using tapfit::testing::TemporaryFolder;

constexpr double beam_kg = 7850.0 * testing::beam_area;

/// Frequencies of the clamped beam, E times `stiffer`, with a mass at its tip
/// of mu times its own: the roots b = beta L of
///
///   1 + cos b cosh b + mu b (cos b sinh b - sin b cosh b) = 0.
///
/// Source: R. D. Blevins, "Formulas for Natural Frequency and Mode Shape",
/// 1979, table 8-8.
std::vector<double> beam_with_tip_mass(double mu, double stiffer = 1.0) {
  const auto off = [mu](double b) {
    return 1.0 + std::cos(b) * std::cosh(b) +
           mu * b * (std::cos(b) * std::sinh(b) - std::sin(b) * std::cosh(b));
  };
  const double unit =
      std::sqrt(stiffer * 2.1e11 * testing::beam_inertia / beam_kg) / two_pi;
  std::vector<double> hz;
  constexpr double step = 0.01;
  for (double at = step; hz.size() < 5; at += step) {
    if (off(at) * off(at + step) > 0.0) continue;
    double low = at;
    double high = at + step;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (off(low) * off(middle) > 0.0 ? low : high) = middle;
    }
    hz.push_back(low * low * unit);
  }
  return hz;
}

std::vector<StatedChange> tip_mass(double kg) {
  return {parse_stated_change(fmt::format("added-mass@21={}", kg))};
}

/// The beam's measured modes, with scatter.
void write_beam(const TemporaryFolder& folder,
                double stiffer,
                const testing::Scatter& scatter) {
  const std::vector<Dof> points = testing::beam_points();
  testing::TrueModes truth = testing::clamped_beam(points);
  for (double& hz : truth.hz) hz *= std::sqrt(stiffer);
  testing::write_modal_bundle(
      folder,
      testing::beam_text(),
      truth,
      points,
      scatter,
      R"(, "uncertain": [{"material": 1, "property": "E"}])");
}

/// The same with a spring to ground at its tip, kappa = k L^3 / E I:
///
///   1 + cos b cosh b + kappa / b^3 (sin b cosh b - cos b sinh b) = 0.
///
/// Source: as above; kappa = infinity is the clamped and pinned beam.
double sprung_beam_fault(double kappa, double b) {
  return 1.0 + std::cos(b) * std::cosh(b) +
         kappa / (b * b * b) *
             (std::sin(b) * std::cosh(b) - std::cos(b) * std::sinh(b));
}

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
