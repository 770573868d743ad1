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

TEST(Wireframe, OfATestAloneHoldsItsPoints) {
  acquisition::TestGeometry geometry;
  geometry.nodes = {{3, {0.0, 0.0, 0.0}}, {8, {0.5, 0.25, 0.0}}};
  // At point 8, X is the test's Y.
  geometry.directions[8] << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Wireframe wire = wireframe(geometry);
  ASSERT_EQ(wire.points.cols(), 2);
  EXPECT_TRUE(wire.lines.empty());
  EXPECT_EQ(wire.index.at(-8), wire.index.at(8));
  EXPECT_EQ(wire.points.col(wire.index.at(8)), Eigen::Vector3d(0.5, 0.25, 0.0));
  // What is measured there is along an axis of the point's that is named so
  // that turning it by `axes` gives the test's axes again.
  const Dof dof = acquisition::at_own_point(geometry, {8, 1, 1});
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  along(dof.component - 1) = dof.sign;
  EXPECT_LT(
      (along_basic(wire, {{dof.node, along}}).at(-8) - Eigen::Vector3d::UnitY())
          .norm(),
      1e-12);
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
