#include "tui/views/compare_view.hpp"

#include "tests/tui/support/canvases.hpp"
#include "tests/tui/support/fake_results.hpp"
#include "tests/tui/support/holds.hpp"
#include "tui/views/compared_modes.hpp"
#include "tui/widgets/mac_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

TEST(CompareView, ShowsErrorFloorPairsAndMap) {
  const updating::Comparison c = testing::fake_comparison(0.05);
  const signal::FrfSet frfs = testing::fake_frfs();
  for (const Canvas& canvas : sizes) {
    const Screen s = compare_view({c, frfs, nullptr}, {}, canvas);
    EXPECT_TRUE(
        holds(s, "error 38.8 % (floor 3.1 %: noise 1.2 %, mesh 2.9 %)"));
    EXPECT_TRUE(holds(s, "17.500    18.375    +5.00  0.970")) << s.to_text();
    EXPECT_TRUE(holds(s, "87"));
    EXPECT_TRUE(holds(s, "measured"));
    EXPECT_TRUE(holds(s, "model"));
  }
}

// A cell within the floor is as good as it gets, whatever the others are.
TEST(CompareView, AnchorsItsMapToTheFloor) {
  updating::Comparison c = testing::fake_comparison(0.0);
  c.frf_band_error = Eigen::MatrixXd::Constant(4, 3, 0.0036);
  const signal::FrfSet frfs = testing::fake_frfs();
  const auto hottest = [&] {
    const Screen s = compare_view({c, frfs, nullptr}, {}, sizes[1]);
    int heat = 0;
    for (int y = 0; y < s.height(); ++y) {
      for (int x = 0; x < s.width(); ++x) {
        heat = std::max<int>(heat, s.at(x, y).style.heat);
      }
    }
    return heat;
  };
  EXPECT_EQ(hottest(), 0);
  c.frf_band_error(1, 1) = 10.0 * c.floor;
  EXPECT_EQ(hottest(), heat_levels);
  c.frf_band_error(1, 1) = 3.0 * c.floor;
  EXPECT_GT(hottest(), 0);
  EXPECT_LT(hottest(), 3);
}

// A free plate's six push its own modes off the screen.
TEST(CompareView, LeavesRigidBodyModesOutOfTheMac) {
  updating::Comparison c = testing::fake_comparison(0.05);
  const Eigen::VectorXd own = c.modes.frequency_hz;
  c.modes.frequency_hz.resize(9);
  c.modes.frequency_hz << Eigen::VectorXd::Constant(6, 1e-4), own;
  Eigen::MatrixXd mac = Eigen::MatrixXd::Zero(3, 9);
  mac.rightCols(3) = c.mac;
  c.mac = mac;
  EXPECT_EQ(rigid_modes(c.modes.frequency_hz), 6);
  const signal::FrfSet frfs = testing::fake_frfs();
  CompareState state;
  state.focus = CompareState::Focus::Mac;
  const Screen s = compare_view({c, frfs, nullptr}, state, sizes[0]);
  EXPECT_TRUE(holds(s, "6 rigid-body modes left out")) << s.to_text();
  EXPECT_TRUE(holds(s, "97    0    0")) << s.to_text();
  std::size_t column = 0;
  EXPECT_TRUE(step_column(column, c.modes.frequency_hz, Key(U'l')));
  EXPECT_EQ(column, 7U);
  EXPECT_TRUE(step_column(column, c.modes.frequency_hz, Key(U'h')));
  EXPECT_TRUE(step_column(column, c.modes.frequency_hz, Key(U'h')));
  EXPECT_EQ(column, 6U);
}

TEST(CompareView, ShowsEveryBand) {
  updating::Comparison c = testing::fake_comparison(0.05);
  c.bands = {{1, 1.98, 0.1},
             {1.98, 3.91, 0.1},
             {3.91, 7.75, 0.1},
             {7.75, 15.3, 0.1},
             {15.3, 30.3, 0.1},
             {30.3, 60, 0.1}};
  c.frf_band_error = Eigen::MatrixXd::Constant(4, 6, 0.1);
  c.frf_band_error.col(5).setConstant(0.77);
  const signal::FrfSet frfs = testing::fake_frfs();
  const Screen narrow = compare_view({c, frfs, nullptr}, {}, sizes[0]);
  EXPECT_TRUE(holds(narrow, "2.0 3.9 7.8  15  30  60")) << narrow.to_text();
  EXPECT_TRUE(holds(narrow, "10  77")) << narrow.to_text();
  const Screen wide = compare_view({c, frfs, nullptr}, {}, {160, 40, false});
  EXPECT_TRUE(holds(wide, "1.98 3.91 7.75 15.3 30.3 60.0")) << wide.to_text();
}

TEST(CompareView, ShowsModesWithoutAPartner) {
  updating::Comparison c = testing::fake_comparison(0.05);
  c.pairs.erase(c.pairs.begin() + 1);
  c.modes.frequency_hz[0] = 9.5e-5;
  const modal::ModeSet modes = testing::fake_modes();
  const signal::FrfSet frfs = testing::fake_frfs();
  CompareState state;
  state.focus = CompareState::Focus::Pairs;
  const CompareInput input{c, frfs, nullptr, &modes};
  for (const Canvas& canvas : sizes) {
    state.focus = CompareState::Focus::Pairs;
    Screen s = compare_view(input, state, canvas);
    EXPECT_TRUE(holds(s, "17.500         –        –      –")) << s.to_text();
    EXPECT_TRUE(holds(s, "–    18.375        –      –")) << s.to_text();
    state.focus = CompareState::Focus::Mac;
    s = compare_view(input, state, canvas);
    EXPECT_TRUE(holds(s, "17.50 ")) << s.to_text();
    EXPECT_TRUE(holds(s, "1 rigid-body mode left out")) << s.to_text();
    EXPECT_TRUE(holds(s, "18.4 32.8")) << s.to_text();
  }
}

// Rigid-body modes that nobody measured are no difference; the sign of a small
// one is a minus as on screen 7.
TEST(CompareView, ListsNoRigidBodyModesWithoutAPartner) {
  updating::Comparison c = testing::fake_comparison(0.05);
  c.modes.frequency_hz.conservativeResize(4);
  c.modes.frequency_hz << 9.5e-5, 5.25, 18.4, 32.8;
  for (updating::ModePair& pair : c.pairs) ++pair.model;
  c.pairs[0].error_percent = -0.013;
  c.pairs[1].error_percent = 0.001;
  const modal::ModeSet modes = testing::fake_modes();
  const signal::FrfSet none;
  const Table table =
      compared_table(compared_modes({c, none, nullptr, &modes}));
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0].cells[2], "−0.01");
  EXPECT_EQ(table.rows[1].cells[2], "0.00");
}

TEST(CompareView, WrapsALongContour) {
  updating::Comparison c = testing::fake_comparison(0.05);
  c.contour = std::string(60, 'x') + " on a line of its own";
  const signal::FrfSet frfs = testing::fake_frfs();
  EXPECT_TRUE(holds(compare_view({c, frfs, nullptr}, {}, sizes[0]), "\n own\n"))
      << compare_view({c, frfs, nullptr}, {}, sizes[0]).to_text();
}

TEST(CompareView, KeepsNumbersThatAreNoneAway) {
  updating::Comparison c = testing::fake_comparison(0.05);
  const double nan = std::nan("");
  c.error = nan;
  c.frf_band_error.setConstant(nan);
  c.frf_error.assign(4, nan);
  c.model_frfs[0].setConstant(nan);
  const signal::FrfSet frfs = testing::fake_frfs();
  EXPECT_FALSE(holds(compare_view({c, frfs, nullptr}, {}, {}), "nan"));
}

}  // namespace
}  // namespace tapfit::tui
