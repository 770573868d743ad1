#include "tui/widgets/plot.hpp"

#include "tests/support/matchers.hpp"
#include "tui/screen/palette.hpp"
#include "tui/widgets/ticks.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace tapfit::tui {
namespace {

Curve curve(const std::vector<double>& x, const std::vector<double>& y) {
  Curve c;
  c.x = Eigen::Map<const Eigen::VectorXd>(x.data(),
                                          static_cast<Eigen::Index>(x.size()));
  c.y = Eigen::Map<const Eigen::VectorXd>(y.data(),
                                          static_cast<Eigen::Index>(y.size()));
  return c;
}

std::string drawn(const Plot& plot, int width, int height, bool ascii) {
  Screen screen(width, height, ascii);
  draw_plot(screen, screen.area(), plot);
  return screen.to_text();
}

TEST(Plot, DrawsAStraightLineInAscii) {
  Plot plot;
  plot.x = {"t", "s", 0.0, 10.0, false};
  plot.y = {"y", "m", 0.0, 10.0, false};
  plot.curves.push_back(curve({0.0, 10.0}, {0.0, 10.0}));
  // Eleven columns and six rows for ten by ten: one row per two columns.
  EXPECT_EQ(drawn(plot, 18, 9, true),
            "y [m]\n"
            "   10|          *\n"
            "     |        **\n"
            "     |      **\n"
            "    5|    **\n"
            "     |  **\n"
            "    0|**\n"
            "     +-----------\n"
            "      0     t [s]\n");
}

// Eleven by eleven cells of 10 x 20 pixels: values 0 to 10 are at their
// middles.
TEST(Plot, DrawsInPixelsWhereTheScreenHasThem) {
  Plot plot;
  plot.x = {"t", "s", 0.0, 10.0, false};
  plot.y = {"y", "m", 0.0, 10.0, false};
  plot.curves.push_back(curve({0.0, 10.0}, {0.0, 10.0}));
  plot.curves.front().pen.colour = Colour::Sky;
  plot.cursor = 5.0;
  plot.shades.push_back({8.0, 10.0, {.colour = Colour::Grey}});
  plot.markers.push_back({2.0});
  Canvas canvas{18, 14, false};
  canvas.pixels = {10, 20};
  Screen screen(canvas);
  draw_plot(screen, screen.area(), plot);
  ASSERT_EQ(screen.pictures().size(), 1U);
  const PixelPicture& drawn = screen.pictures()[0];
  EXPECT_EQ(drawn.rect, (Rect{6, 1, 11, 11}));
  const auto is = [&](int x, int y, Colour colour) {
    const Pixel& pixel = drawn.at(x, y);
    return pixel.cover > 127 && pixel.ink == ink_number(colour, false);
  };
  for (int value = 0; value <= 10; ++value) {
    EXPECT_TRUE(is(5 + 10 * value, 210 - 20 * value, Colour::Sky)) << value;
  }
  // Nothing is left or right of the first and the last value.
  EXPECT_EQ(drawn.at(2, 210).cover, 0);
  EXPECT_TRUE(is(55, 20, Colour::Yellow));
  int shaded = 0;
  for (int x = 86; x < 104; ++x) shaded += drawn.at(x, 215).cover > 0 ? 1 : 0;
  EXPECT_NEAR(shaded, 18 / 4, 1);
  // A glyph stands where the value is: columns begin at 6.
  EXPECT_EQ(screen.at(8, 1).glyph, U'▼');
  const std::string text = screen.to_text();
  EXPECT_EQ(text.find("░"), text.npos);
}

TEST(Plot, DrawsTheSameLineInBraille) {
  Plot plot;
  plot.x = {"t", "s", 0.0, 1.0, false};
  plot.y = {"y", "", 0.0, 1.0, false};
  plot.curves.push_back(curve({0.0, 1.0}, {0.0, 1.0}));
  // Sixteen by twelve dots from (0, 11) to (15, 0): the first cell holds
  // (0, 11) and (1, 10), the last one (14, 1) and (15, 0).
  EXPECT_EQ(drawn(plot, 15, 6, false),
            "y\n"
            "  1.0┤     ⢀⠔⠊\n"
            "  0.5┤  ⢀⡠⠊⠁\n"
            "    0┤⡠⠔⠁\n"
            "     └┴───┴──┴\n"
            "      0  t [s]\n");
}

TEST(Plot, TakesEmptyConstantAndSinglePointData) {
  Plot plot;
  plot.y.log = true;
  EXPECT_NO_THROW(drawn(plot, 30, 8, false));
  plot.curves.push_back(curve({}, {}));
  EXPECT_NO_THROW(drawn(plot, 30, 8, false));
  plot.curves = {curve({1.0}, {5.0})};
  EXPECT_THAT(drawn(plot, 30, 8, true), HasSubstr("*"));
  plot.y.log = false;
  plot.curves = {curve({0.0, 1.0}, {3.0, 3.0})};
  const Ranges ranges = fit_ranges(plot);
  EXPECT_LT(ranges.y.lo, 3.0);
  EXPECT_GT(ranges.y.hi, 3.0);
  EXPECT_THAT(drawn(plot, 30, 8, true), HasSubstr("****"));
}

TEST(Plot, LeavesOutWhatIsNoNumber) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  Plot plot;
  plot.curves = {curve({0, 1, 2, 3, 4}, {1.0, nan, inf, -inf, 2.0})};
  for (const bool log : {false, true}) {
    plot.y.log = log;
    const std::string text = drawn(plot, 40, 10, false);
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("inf")));
  }
  const Ranges ranges = fit_ranges(plot);
  EXPECT_TRUE(std::isfinite(ranges.y.lo) && std::isfinite(ranges.y.hi));
}

TEST(Plot, LogAxisNeverReachesZero) {
  Plot plot;
  plot.y.log = true;
  plot.curves = {curve({0, 1, 2}, {0.0, 1e-30, 10.0})};
  const Ranges ranges = fit_ranges(plot);
  EXPECT_GT(ranges.y.lo, 0.0);
  // Eight decades at the most, and a little room.
  EXPECT_LT(ranges.y.hi / ranges.y.lo, 1e10);
}

TEST(Plot, ReadsOutTheNearestPoint) {
  Plot plot;
  plot.x.unit = "Hz";
  plot.y.unit = "N";
  plot.curves = {curve({1, 2, 3}, {10, 20, 30})};
  plot.curves[0].label = "measured";
  EXPECT_EQ(read_out(plot, 2.2), "2 Hz: measured 20 N");
  plot.curves[0].y[1] = std::nan("");
  EXPECT_EQ(read_out(plot, 2.2), "");
}

TEST(Plot, ShowsCursorMarkerAndShade) {
  Plot plot;
  plot.x = {"", "", 0.0, 10.0, false};
  plot.curves.push_back(curve({0.0, 10.0}, {0.0, 0.0}));
  plot.cursor = 5.0;
  plot.markers.push_back({2.0, U'v', {}});
  plot.shades.push_back({6.0, 8.0, {}});
  const std::string text = drawn(plot, 30, 8, true);
  EXPECT_THAT(text, HasSubstr("v"));
  EXPECT_THAT(text, HasSubstr("| ......"));
}

std::vector<std::string> labels_of(const std::vector<Tick>& ticks) {
  std::vector<std::string> labels;
  for (const Tick& tick : ticks) labels.push_back(tick.label);
  return labels;
}

// One tick tells no scale: whatever the range, there are two.
TEST(Ticks, AreNeverFewerThanTwo) {
  using Labels = std::vector<std::string>;
  EXPECT_EQ(labels_of(ticks(-0.7, 13.9, false, 2)), (Labels{"0", "10"}));
  EXPECT_EQ(labels_of(ticks(-9.0, 9.0, false, 2)), (Labels{"-5", "0", "5"}));
  EXPECT_EQ(labels_of(ticks(0.09, 0.19, true, 4)), (Labels{"0.10", "0.15"}));
  EXPECT_EQ(labels_of(ticks(6.1, 9.2, true, 2)), (Labels{"7", "8", "9"}));
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> uniform(-3.0, 3.0);
  for (int i = 0; i < 2000; ++i) {
    const double lo = std::pow(10.0, uniform(random));
    const double hi = lo * (1.0 + std::pow(10.0, uniform(random)));
    const int most = 2 + i % 7;
    for (const bool log : {false, true}) {
      const std::size_t count = ticks(lo, hi, log, most).size();
      EXPECT_GE(count, 2U) << lo << " to " << hi;
      EXPECT_LE(count, static_cast<std::size_t>(most) + 3);
    }
  }
}

TEST(Ticks, OfAnglesAreQuartersOfATurn) {
  using Labels = std::vector<std::string>;
  EXPECT_EQ(labels_of(degree_ticks(-190, 190, 5)),
            (Labels{"-180", "-90", "0", "90", "180"}));
  EXPECT_EQ(labels_of(degree_ticks(-190, 190, 3)),
            (Labels{"-180", "0", "180"}));
  EXPECT_EQ(labels_of(degree_ticks(10, 40, 3)),
            (Labels{"10", "20", "30", "40"}));
}

TEST(Ticks, AreRound) {
  const std::vector<Tick> found = ticks(0.0, 40.0, false, 4);
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[1].label, "10");
  EXPECT_EQ(ticks(0.1, 100.0, true, 4)[0].label, "0.1");
  EXPECT_TRUE(ticks(1.0, 1.0, false, 4).empty());
  EXPECT_TRUE(ticks(-1.0, 1.0, true, 4).empty());
}

}  // namespace
}  // namespace tapfit::tui
