#include "tui/views/frf_view.hpp"

#include "tests/tui/support/fake_results.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tapfit::tui
