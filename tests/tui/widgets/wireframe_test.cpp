#include "tui/widgets/wireframe.hpp"

#include "tests/support/matchers.hpp"
#include "tests/tui/support/fake_workbench.hpp"

namespace tapfit::tui {
namespace {

TEST(Wireframe, HoldsEveryEdgeOnce) {
  const Wireframe wire = wireframe(testing::fake_deck());
  EXPECT_EQ(wire.points.cols(), 6);
  EXPECT_EQ(wire.lines.size(), 7U);  // two quadrilaterals share one edge
}

TEST(Wireframe, DrawsMarksAtTheirGrids) {
  const Wireframe wire = wireframe(testing::fake_deck());
  Scene scene;
  scene.marks = {{5, U'@', {}, "five"}, {99, U'!', {}, ""}};
  Screen screen(40, 12);
  draw_wireframe(screen, screen.area(), wire, scene, {});
  const std::string text = screen.to_text();
  EXPECT_THAT(text, HasSubstr("@"));
  EXPECT_THAT(text, Not(HasSubstr("!")));
}

TEST(Wireframe, SeenFromAboveALongStripFillsTheWidth) {
  const Wireframe wire = wireframe(testing::fake_deck());
  Screen screen(40, 12, true);
  draw_wireframe(screen, screen.area(), wire, {}, {0.0, 90.0, 1.0});
  int first = 40;
  int last = 0;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 12; ++y) {
      if (screen.at(x, y).glyph == U' ') continue;
      first = std::min(first, x);
      last = std::max(last, x);
    }
  }
  // 84 % of the width (the margin left), to a cell.
  EXPECT_NEAR(last - first, 0.84 * 40, 2.0);
}

TEST(Wireframe, TakesDegenerateStructures) {
  Screen screen(20, 6);
  structure::Deck deck;
  EXPECT_NO_THROW(
      draw_wireframe(screen, screen.area(), wireframe(deck), {}, {}));
  deck.grids.push_back({1, Eigen::Vector3d::Zero()});
  Scene scene;
  scene.marks = {{1, U'@', {}, ""}};
  scene.stems[1] = Eigen::Vector3d::Zero();
  draw_wireframe(screen, screen.area(), wireframe(deck), scene, {});
  EXPECT_THAT(screen.to_text(), HasSubstr("@"));
}

}  // namespace
}  // namespace tapfit::tui
