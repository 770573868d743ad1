#include "tui/views/frf_view.hpp"

#include "tests/tui/support/fake_results.hpp"
#include "tui/views/frf_panels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace tapfit::tui {
namespace {

/// The fake FRFs at frequencies and of sizes that take many digits.
signal::FrfSet long_numbers() {
  signal::FrfSet frfs = testing::fake_frfs();
  frfs.s *= 31.7;
  for (signal::Frf& frf : frfs.frfs) {
    frf.H *= -std::polar(1.234e-6, 0.1);
    frf.variance *= 1e-12;
  }
  return frfs;
}

std::string last_line(const Screen& screen) {
  std::string text = screen.to_text();
  text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

TEST(FrfView, ReadsOutWholeNumbersOnANarrowScreen) {
  const signal::FrfSet frfs = long_numbers();
  FrfState state;
  state.range.cursor = 1000.0;
  state.range.cursor_set = true;
  using Panel = FrfState::Panel;
  for (const Panel panel : {Panel::Phase, Panel::Parts, Panel::Nyquist}) {
    state.panel = panel;
    const std::string line = last_line(frf_view(frfs, state, {80, 21, false}));
    EXPECT_NE(line.find("coh 0.9870  sd "), std::string::npos) << line;
    EXPECT_EQ(line.find("…"), std::string::npos) << line;
  }
  state.mark = 101.25;
  const std::string band = last_line(frf_view(frfs, state, {80, 21, false}));
  EXPECT_NE(band.find("coh 0.9870"), std::string::npos) << band;
  EXPECT_EQ(band.find("…"), std::string::npos) << band;
  const std::string wide = last_line(frf_view(frfs, state, {120, 32, false}));
  EXPECT_NE(wide.find("coherence 0.9870"), std::string::npos) << wide;
}

TEST(FrfView, CountsTheOverlaysWhoseSizesDoNotFit) {
  const signal::FrfSet frfs = long_numbers();
  FrfState state;
  state.range.cursor = 1000.0;
  state.range.cursor_set = true;
  state.tagged = {1, 2, 3};
  const std::string line = last_line(frf_view(frfs, state, {80, 21, false}));
  EXPECT_NE(line.find("  +2"), std::string::npos) << line;
  EXPECT_EQ(line.find("…"), std::string::npos) << line;
}

// A file of ready FRFs may have neither hits nor scatter nor coherence.
TEST(FrfView, ShowsNothingAsMeasuredThatWasNot) {
  signal::FrfSet frfs = testing::fake_frfs();
  frfs.s.real().setZero();
  for (signal::Frf& frf : frfs.frfs) {
    frf.coherence.setOnes();
    frf.variance.setZero();
    frf.hits = 0;
  }
  FrfState state;
  const std::string text = frf_view(frfs, state, {120, 32, false}).to_text();
  for (const char* words : {"1.000", "0.00", "exponential window"}) {
    EXPECT_EQ(text.find(words), std::string::npos) << words << "\n" << text;
  }
  state.range.cursor = frfs.frequency_hz()[3];
  state.range.cursor_set = true;
  const std::string line = last_line(frf_view(frfs, state, {120, 32, false}));
  EXPECT_EQ(line.find("coherence"), std::string::npos) << line;
  EXPECT_EQ(line.find("sd"), std::string::npos) << line;
}

/// Behind "|H| ".
double size_in(const std::string& line) {
  const std::size_t at = line.find("|H| ");
  return at == std::string::npos ? 0.0 : std::stod(line.substr(at + 4));
}

// A = s M = s^2 R; the fake FRFs' lines lie on the axis of frequencies but for
// their window.
TEST(FrfView, TurnsAccelerancesIntoMobilitiesAndReceptances) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const Eigen::Index line = frfs.lines() / 2;
  FrfState state;
  state.range.cursor = frfs.frequency_hz()(line);
  state.range.cursor_set = true;
  const auto shown = [&](signal::FrfForm form) {
    state.form = form;
    return last_line(frf_view(frfs, state, {120, 32, false}));
  };
  const std::string a = shown(signal::FrfForm::Accelerance);
  const std::string m = shown(signal::FrfForm::Mobility);
  const std::string r = shown(signal::FrfForm::Receptance);
  EXPECT_NE(a.find("(m/s²)/N"), std::string::npos) << a;
  EXPECT_NE(m.find("(m/s)/N"), std::string::npos) << m;
  EXPECT_NE(r.find(" m/N"), std::string::npos) << r;
  const double size = std::abs(frfs.frfs.front().H(line));
  const double s = std::abs(frfs.s(line));
  // Four digits are shown.
  EXPECT_NEAR(size_in(a), size, 1e-3 * size);
  EXPECT_NEAR(size_in(m), size / s, 1e-3 * size / s);
  EXPECT_NEAR(size_in(r), size / (s * s), 1e-3 * size / (s * s));
  // The scatter goes with it.
  state.form = signal::FrfForm::Mobility;
  const FrfChoice choice = chosen_frfs(frfs, {0}, state.form);
  EXPECT_DOUBLE_EQ(choice.selected().variance(line),
                   frfs.frfs.front().variance(line) / (s * s));
}

TEST(FrfView, ShowsDecibels) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const Eigen::Index line = frfs.lines() / 2;
  FrfState state;
  state.scale = MagnitudeScale::Decibels;
  state.range.cursor = frfs.frequency_hz()(line);
  state.range.cursor_set = true;
  const Screen screen = frf_view(frfs, state, {120, 32, false});
  EXPECT_NE(screen.to_text().find("dB re 1 (m/s²)/N"), std::string::npos);
  const std::string text = last_line(screen);
  EXPECT_NE(text.find(" dB"), std::string::npos) << text;
  EXPECT_NEAR(size_in(text),
              20.0 * std::log10(std::abs(frfs.frfs.front().H(line))),
              0.051);
}

// A = s^2 R says nothing of R at s = 0, where a free structure's is infinite.
TEST(FrfView, LeavesOutWhatIsNotKnownAtNoFrequency) {
  signal::FrfSet frfs = testing::fake_frfs();
  frfs.s = Eigen::VectorXd::LinSpaced(frfs.lines(), 0.0, 100.0) *
           std::complex<double>(0.0, 1.0);
  using signal::FrfForm;
  for (const FrfForm form : {FrfForm::Mobility, FrfForm::Receptance}) {
    const FrfChoice choice = chosen_frfs(frfs, {0}, form);
    const Eigen::Index lines = frfs.lines() - 1;
    ASSERT_EQ(choice.frfs.lines(), lines);
    EXPECT_EQ(choice.frfs.s(0), frfs.s(1));
    EXPECT_EQ(choice.selected().H.size(), lines);
    EXPECT_EQ(choice.selected().variance.size(), lines);
    EXPECT_EQ(choice.selected().coherence.size(), lines);
    EXPECT_GT(std::abs(choice.selected().H(0)), 0.0);
  }
  const FrfChoice measured = chosen_frfs(frfs, {0}, FrfForm::Accelerance);
  EXPECT_EQ(measured.frfs.lines(), frfs.lines());
}

// Driving points and reciprocity are looked at as accelerances.
TEST(FrfView, ChecksAccelerances) {
  const signal::FrfSet frfs = testing::fake_frfs();
  FrfState state;
  state.range.cursor = frfs.frequency_hz()(frfs.lines() / 2);
  state.range.cursor_set = true;
  state.checks = true;
  const Canvas canvas{120, 32, false};
  const std::string before = last_line(frf_view(frfs, state, canvas));
  state.form = signal::FrfForm::Receptance;
  EXPECT_EQ(last_line(frf_view(frfs, state, canvas)), before);
}

TEST(InScale, LeavesAGapWhereThereIsNothing) {
  Plot plot;
  plot.y.unit = "m/N";
  Curve curve{"", {}, {}, {}, {}, {}};
  curve.x = curve.y = Eigen::Vector3d(1.0, 10.0, 0.0);
  plot.curves.push_back(curve);
  const Plot shown = in_scale(plot, MagnitudeScale::Decibels);
  EXPECT_DOUBLE_EQ(shown.curves[0].y(1), 20.0);
  EXPECT_FALSE(std::isfinite(shown.curves[0].y(2)));
  EXPECT_FALSE(shown.y.log);
  EXPECT_TRUE(in_scale(plot, MagnitudeScale::Logarithmic).y.log);
  const Ranges ranges = fit_ranges(shown);
  EXPECT_TRUE(std::isfinite(ranges.y.lo) && std::isfinite(ranges.y.hi));
}

TEST(InScale, GoesRound) {
  MagnitudeScale scale = MagnitudeScale::Logarithmic;
  for (int k = 0; k < 3; ++k) scale = next(scale);
  EXPECT_EQ(scale, MagnitudeScale::Logarithmic);
}

}  // namespace
}  // namespace tapfit::tui
