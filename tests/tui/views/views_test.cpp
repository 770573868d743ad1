// Views from hand-made results: the numbers shown are the results' numbers.
#include "tests/tui/support/canvases.hpp"
#include "tests/tui/support/fake_workbench.hpp"
#include "tests/tui/support/holds.hpp"
#include "tui/views/frf_view.hpp"
#include "tui/views/modes_view.hpp"
#include "tui/views/recording_view.hpp"
#include "tui/views/report_view.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::tui {
namespace {

std::vector<Trace> traces() {
  std::vector<Trace> all;
  for (const auto& recording : testing::fake_recordings()) {
    all.push_back(trace(recording));
  }
  return all;
}

TEST(RecordingView, ShowsHitsAndReasons) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  const acquisition::HitSet hits = testing::fake_hits();
  const std::vector<Trace> all = traces();
  for (const Canvas& canvas : sizes) {
    const Screen s = recording_view({bundle, all, hits}, {}, canvas);
    EXPECT_TRUE(holds(s, "4.000    21.0  8.0  ✗ double")) << s.to_text();
    EXPECT_TRUE(holds(s, "▼"));
    EXPECT_TRUE(holds(s, "✗"));
    EXPECT_TRUE(holds(s, "block 2.734 s, trigger 1.5 N"));
    RecordingState state;
    state.list.selected = 1;
    const Screen second = recording_view({bundle, all, hits}, state, canvas);
    EXPECT_TRUE(holds(second, "trigger 1.5 N   #2 double"));
    state.statements = true;
    const Screen why = recording_view({bundle, all, hits}, state, canvas);
    EXPECT_TRUE(holds(why, "block 2.73 s: the gap between hits"));
  }
}

TEST(RecordingView, ListsAllRuns) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  const acquisition::HitSet hits = testing::fake_hits();
  const signal::FrfSet frfs = testing::fake_frfs();
  const std::vector<Trace> all = traces();
  RecordingState state;
  state.overview = true;
  RecordingInput input{bundle, all, hits};
  EXPECT_TRUE(holds(recording_view(input, state, sizes[0]), "…"));
  input.frfs = &frfs;
  for (const Canvas& canvas : sizes) {
    const Screen s = recording_view(input, state, canvas);
    EXPECT_TRUE(holds(s, "2 runs, ")) << s.to_text();
    EXPECT_TRUE(holds(s, "run-01.wav")) << s.to_text();
    EXPECT_TRUE(holds(s, "0.9870 acc1")) << s.to_text();
    EXPECT_TRUE(holds(s, "1 double")) << s.to_text();
  }
}

TEST(RecordingView, TakesABundleWithoutRecordings) {
  const acquisition::TestBundle bundle;
  const acquisition::HitSet hits;
  const std::vector<Trace> none;
  EXPECT_TRUE(
      holds(recording_view({bundle, none, hits}, {}, {}), "no recordings"));
}

TEST(FrfView, ReadsOutUnderTheCursor) {
  const signal::FrfSet frfs = testing::fake_frfs();
  FrfState state;
  state.range.cursor = 5.0;
  state.range.cursor_set = true;
  const double size = std::abs(frfs.frfs[0].H[16]);  // 1 Hz + 16 / 4 Hz
  for (const Canvas& canvas : sizes) {
    const Screen s = frf_view(frfs, state, canvas);
    EXPECT_TRUE(holds(s, fmt::format("5.000 Hz   |H| {:.4g}", size)))
        << s.to_text();
    EXPECT_TRUE(holds(s, "coherence 0.9870"));
  }
}

TEST(FrfView, GoesRoundItsPlots) {
  using Panel = FrfState::Panel;
  const signal::FrfSet frfs = testing::fake_frfs();
  const std::vector<std::pair<Panel, std::string>> panels{
      {Panel::Phase, "phase [deg]"},
      {Panel::Coherence, "coherence"},
      {Panel::Parts, "Im H [(m/s²)/N]"},
      {Panel::Nyquist, "circle fit, "},
      {Panel::Magnitude, "|H| [(m/s²)/N]"}};
  for (const Canvas& canvas : sizes) {
    for (const auto& [panel, words] : panels) {
      FrfState state;
      state.panel = panel;
      state.log_f = true;
      const Screen s = frf_view(frfs, state, canvas);
      EXPECT_TRUE(holds(s, words)) << s.to_text();
    }
  }
}

TEST(FrfView, LaysFrfsOverEachOther) {
  const signal::FrfSet frfs = testing::fake_frfs();
  FrfState state;
  state.tagged = {1};
  state.range.cursor = 5.0;
  state.range.cursor_set = true;
  const Screen s = frf_view(frfs, state, {120, 32, false});
  EXPECT_TRUE(holds(s, "* " + signal::name(frfs.frfs[1]))) << s.to_text();
  EXPECT_TRUE(holds(s, "╌ " + signal::name(frfs.frfs[1])));
  EXPECT_TRUE(holds(s,
                    fmt::format("{} {:.4g}",
                                signal::name(frfs.frfs[1]),
                                std::abs(frfs.frfs[1].H[16]))));
}

TEST(FrfView, ReadsOutTheBand) {
  signal::FrfSet frfs = testing::fake_frfs();
  frfs.frfs[0].H.setConstant({3.0, 4.0});
  frfs.frfs[0].H[20] = {0.0, 6.0};  // at 6 Hz
  FrfState state;
  state.range.cursor = 7.0;
  state.range.cursor_set = true;
  state.mark = 5.0;
  // Nine lines a quarter of a Hz apart, eight of size 5 and one of size 6.
  const double rms = std::sqrt((8.0 * 25.0 + 36.0) / 9.0);
  const Screen s = frf_view(frfs, state, {120, 32, false});
  EXPECT_TRUE(
      holds(s, fmt::format("5.00 to 7.00 Hz (Δ 2.00 Hz): rms {:.4g}", rms)))
      << s.to_text();
  EXPECT_TRUE(holds(s, "largest at 6.00 Hz"));
}

TEST(FrfView, HoldsDrivingPointsAgainstPhysics) {
  signal::FrfSet frfs = testing::fake_frfs();
  // An oscillator of 1 kg at 10 Hz where it is hit: passive.
  constexpr double w = 62.8;
  for (signal::Frf& frf : frfs.frfs) {
    frf.H = frfs.s.array().square() /
            (frfs.s.array().square() + 0.02 * w * frfs.s.array() + w * w);
    frf.variance.setConstant(1e-6);
  }
  FrfState state;
  state.checks = true;
  const signal::FrfChecks fair = signal::check_frfs(frfs);
  ASSERT_FALSE(fair.driving.empty());
  EXPECT_TRUE(holds(frf_view(frfs, state, {120, 32, false}, &fair),
                    "driving point    OK"));
  for (signal::Frf& frf : frfs.frfs) frf.H = -frf.H;
  const signal::FrfChecks turned = signal::check_frfs(frfs);
  EXPECT_TRUE(holds(frf_view(frfs, state, {120, 32, false}, &turned),
                    "polarity inverted"));
  const signal::FrfChecks none;
  EXPECT_TRUE(holds(frf_view(frfs, state, {}, &none), "No driving point"));
}

// Nothing of it is cut, and the cursor reads the FRF that is checked.
TEST(FrfView, SaysInFullWhatACheckFound) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const signal::FrfChecks checks = signal::check_frfs(frfs);
  ASSERT_FALSE(checks.driving.empty());
  const std::size_t checked = checks.driving[0].frf;
  ASSERT_NE(checked, 0U) << "another one than the list's first";
  FrfState state;
  state.checks = true;
  state.range.cursor = frfs.frequency_hz()[3];
  state.range.cursor_set = true;
  for (const Canvas& canvas : sizes) {
    const Screen s = frf_view(frfs, state, canvas, &checks);
    EXPECT_FALSE(holds(s, "…")) << s.to_text();
    EXPECT_TRUE(holds(s, "of 3 peaks of Im H")) << s.to_text();
    EXPECT_TRUE(
        holds(s, fmt::format("|H| {:.4g} ", std::abs(frfs.frfs[checked].H[3]))))
        << s.to_text();
  }
}

TEST(FrfView, TakesNoFrfs) {
  EXPECT_TRUE(holds(frf_view({}, {}, {}), "no FRF"));
  signal::FrfSet one = testing::fake_frfs();
  one.s.conservativeResize(1);
  for (signal::Frf& frf : one.frfs) {
    frf.H.conservativeResize(1);
    frf.coherence.conservativeResize(1);
    frf.variance.conservativeResize(1);
  }
  EXPECT_NO_THROW((void)frf_view(one, {}, {}));
}

// However many digits its frequency has.
TEST(ModesView, CutsNoMac) {
  const modal::ModeSet modes = testing::fake_modes();
  const signal::FrfSet frfs = testing::fake_frfs();
  const Wireframe wire = wireframe(testing::fake_deck());
  updating::Comparison c = testing::fake_comparison(0.05);
  c.modes.frequency_hz[0] = 2.0775;
  c.pairs[0].model_hz = 2.0775;
  const Screen s = modes_view({modes, &frfs, &wire, &c}, {}, sizes[0]);
  EXPECT_TRUE(holds(s, fmt::format("model 2.0775 Hz, MAC {:.3f}", c.mac(0, 0))))
      << s.to_text();
}

TEST(ModesView, ShowsFrequenciesWithTheirDeviation) {
  const modal::ModeSet modes = testing::fake_modes();
  const signal::FrfSet frfs = testing::fake_frfs();
  const Wireframe wire = wireframe(testing::fake_deck());
  for (const Canvas& canvas : sizes) {
    const Screen s = modes_view({modes, &frfs, &wire, nullptr}, {}, canvas);
    EXPECT_TRUE(holds(s, "17.500 ± 0.003")) << s.to_text();
    EXPECT_TRUE(holds(s, "1.00 ± 0.02"));
    EXPECT_TRUE(holds(s, "0.998"));
  }
}

// A test of frequencies alone has neither shapes nor poles.
TEST(ModesView, ShowsOfGivenFrequenciesNothingElse) {
  modal::ModeSet modes;
  modes.modes.resize(2);
  modes.modes[0].frequency_hz = 7.94;
  modes.modes[1].frequency_hz = 9.2;
  const signal::FrfSet frfs;
  updating::Comparison c;
  c.mac = Eigen::MatrixXd::Zero(2, 2);
  c.modes.frequency_hz = Eigen::Vector2d(8.0, 9.0);
  c.pairs = {{0, 0, 7.94, 8.0, 0.8, 0.0}};
  c.pairs[0].has_shape = false;
  const Wireframe wire = wireframe(testing::fake_deck());
  ModesState state;
  for (const bool mac : {false, true}) {
    state.mac = mac;
    const Screen s = modes_view({modes, &frfs, &wire, &c}, state, sizes[1]);
    EXPECT_TRUE(holds(s, "no shapes were given")) << s.to_text();
    EXPECT_FALSE(holds(s, "0.000")) << s.to_text();
    EXPECT_FALSE(holds(s, "MAC 0")) << s.to_text();
    EXPECT_FALSE(holds(s, "stabilisation")) << s.to_text();
  }
}

TEST(ModesView, SaysFirstWhatMovesThePoles) {
  modal::ModeSet modes = testing::fake_modes();
  modes.warnings = {"something else"};
  const Screen s = modes_view(
      {modes, nullptr, nullptr, nullptr, "the sensors' mass, 20 g"}, {}, {});
  EXPECT_TRUE(holds(s, "! the sensors' mass, 20 g (and 1 more in the report)"))
      << s.to_text();
}

TEST(ModesView, ShowsAutoMacOrMacWithTheModel) {
  const modal::ModeSet modes = testing::fake_modes();
  ModesState state;
  state.mac = true;
  const Screen alone =
      modes_view({modes, nullptr, nullptr, nullptr}, state, {});
  EXPECT_TRUE(holds(alone, "AutoMAC"));
  EXPECT_TRUE(holds(alone, "100")) << alone.to_text();
  // (1 - 0.4)^2 / (2 * 1.16) = 0.155
  EXPECT_TRUE(holds(alone, " 16 ")) << alone.to_text();
  const updating::Comparison c = testing::fake_comparison(0.05);
  EXPECT_TRUE(
      holds(modes_view({modes, nullptr, nullptr, &c}, state, {}), "97"));
}

TEST(ModesView, TakesNoModes) {
  modal::ModeSet none;
  EXPECT_TRUE(
      holds(modes_view({none, nullptr, nullptr, nullptr}, {}, {}), "No mode"));
}

TEST(ReportView, TellsADiagnosisFromTheErrorOfItsModel) {
  const updating::Comparison before = testing::fake_comparison(0.05);
  std::vector<updating::Rung> ladder{{updating::base_rung, {}, 0.489, {}},
                                     {updating::uncertain_rung, {}, 0.187, {}},
                                     {"added-mass", {}, 0.023, {}}};
  ladder[2].where.node = 5;
  auto none = std::make_shared<updating::Diagnosis>();
  none->verdict = "none";
  none->floor = 0.021;
  ReportInput input{before, before, ladder, {}, {}, {}};
  input.diagnoses = {{0, none}, {1, none}};
  const Screen s = report_sheet(input, {100, 0});
  EXPECT_TRUE(holds(s, "uncertain properties fitted  ")) << s.to_text();
  EXPECT_FALSE(holds(s, "everywhere"));
  EXPECT_TRUE(holds(s, "error 48.9 % → 48.9 %, floor 2.1 %")) << s.to_text();
  EXPECT_TRUE(holds(s, "error 2.3 % → 2.3 %, floor 2.1 %")) << s.to_text();
}

// "80.7 % → 80.7 %" and a table twice would be of nothing.
TEST(ReportView, TellsOfAnUnchangedModelWhatItIs) {
  const updating::Comparison c = testing::fake_comparison(0.05);
  const ReportInput input{c,
                          c,
                          {{updating::base_rung, {}, 0.388, {}}},
                          {{"E:1", 7.0e10, 0.0, 7.0e10, 7.0e10}},
                          {},
                          {}};
  const Screen s = report_sheet(input, {100, 0});
  EXPECT_TRUE(holds(s, "model as delivered: error 38.8 %")) << s.to_text();
  EXPECT_FALSE(holds(s, "→")) << s.to_text();
  EXPECT_FALSE(holds(s, "Identified")) << s.to_text();
  EXPECT_FALSE(holds(s, "before")) << s.to_text();
  EXPECT_TRUE(holds(s, "model Hz")) << s.to_text();
}

TEST(ReportView, SaysWhereNoPairWasMade) {
  updating::Comparison c = testing::fake_comparison(0.05);
  c.pairs.clear();
  const ReportInput input{
      c, c, {{updating::base_rung, {}, 0.388, {}}}, {}, {}, {}};
  const Screen s = report_sheet(input, {100, 0});
  EXPECT_TRUE(holds(s, "No measured mode was paired with one of the model"))
      << s.to_text();
  EXPECT_FALSE(holds(s, "model Hz")) << s.to_text();
}

TEST(ReportView, ComparesWhatWasIdentifiedWithTheDeck) {
  const updating::Comparison c = testing::fake_comparison(0.05);
  acquisition::TestBundle bundle = testing::fake_bundle();
  bundle.uncertain = {{"material", 1, "E"}};
  structure::Deck deck = testing::fake_deck();
  deck.materials[1].E = 7.0e10;
  deck.shell_properties[1].membrane = 1;
  const ReportInput input{c,
                          c,
                          {{updating::base_rung, {}, 0.388, {}},
                           {updating::uncertain_rung, {}, 0.1, {}}},
                          {{"E:1", 7.07e10, 2.0e8, 7.03e10, 7.11e10}},
                          {},
                          {},
                          &bundle,
                          &deck};
  const Screen s = report_sheet(input, {100, 0});
  EXPECT_TRUE(holds(s, "e10 Pa, +1.00 % to the deck")) << s.to_text();
}

// The verdict was added: its error is that of the ladder, not of another fit.
TEST(ReportView, TellsOneErrorOfTheVerdictAndOfTheModelWithIt) {
  const updating::Comparison before = testing::fake_comparison(0.05);
  auto found = std::make_shared<updating::Diagnosis>(testing::fake_diagnosis());
  std::vector<updating::Rung> ladder{{updating::base_rung, {}, 0.388, {}},
                                     {"added-mass", {.node = 5}, 0.039, {}}};
  ReportInput input{before, before, ladder, {}, {{0, found}}, {}};
  EXPECT_TRUE(holds(report_sheet(input, {100, 0}), "error 38.8 % → 3.9 %"));
  ladder[1].where.node = 6;  // another was added in its place
  EXPECT_TRUE(holds(report_sheet(input, {100, 0}), "error 38.8 % → 3.8 %"));
}

TEST(ReportView, ShowsBeforeAndAfter) {
  const updating::Comparison before = testing::fake_comparison(0.05);
  const updating::Comparison after = testing::fake_comparison(0.01);
  const std::vector<updating::Rung> ladder{{"base", {}, 0.388, {}},
                                           {"added-mass", {}, 0.038, {}}};
  const std::vector<updating::Estimate> found{
      {"mass_kg", 0.0785, 0.0006, 0.077, 0.08}};
  const ReportInput input{
      before, after, ladder, found, {}, {"the mesh is coarse"}};
  for (const int width : {80, 120}) {
    const Screen s = report_sheet(input, {width, 0});
    EXPECT_TRUE(holds(s, "mass 0.07850 ± 0.00060 kg")) << s.to_text();
    EXPECT_TRUE(holds(s, "mean frequency error 5.00 % → 1.00 %"));
    EXPECT_TRUE(holds(s, "17.500     18.375  +5.00 %  0.970    17.675"))
        << s.to_text();
    EXPECT_TRUE(holds(s, "the mesh is coarse"));
  }
  EXPECT_FALSE(holds(report_sheet(input, {80, 0}), "stopped"));
  std::vector<updating::Rung> kept = ladder;
  kept[1].stopped_after = 7;
  EXPECT_TRUE(holds(report_sheet({before, after, kept, {}, {}, {}}, {}),
                    "stopped early, after 7 steps"));
  // Scrolled to its end, the last line is still there.
  EXPECT_TRUE(holds(report_view(input, {1000}, {80, 21, false}), "coarse"));
}

}  // namespace
}  // namespace tapfit::tui
