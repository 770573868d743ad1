#include "tui/widgets/mesh_lines.hpp"

#include "tui/widgets/wireframe.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

/// A plate of n by n quadrilaterals; grid (i, k) has the index i (n + 1) + k.
std::vector<std::vector<int>> plate(int n) {
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const int at = i * (n + 1) + k;
      faces.push_back({at, at + 1, at + n + 2, at + n + 1});
    }
  }
  return faces;
}

TEST(MeshLines, AreCountedFromTheOutline) {
  constexpr int n = 8;
  const auto edges = mesh_edges(plate(n));
  EXPECT_EQ(edges.size(), 2U * n * (n + 1));
  for (const auto& [edge, its] : edges) {
    const int i = edge[0] / (n + 1);
    const int k = edge[0] % (n + 1);
    // Along k the line is that of i, and the other way round.
    const int line = edge[1] == edge[0] + 1 ? i : k;
    EXPECT_EQ(its.depth, std::min(line, n - line)) << i << ' ' << k;
    EXPECT_EQ(its.outline, line == 0 || line == n);
  }
}

TEST(MeshLines, OfTrianglesAndClosedMeshesAreThere) {
  const auto triangles = mesh_edges({{0, 1, 2}, {1, 3, 2}});
  EXPECT_EQ(triangles.size(), 5U);
  for (const auto& [edge, its] : triangles) EXPECT_EQ(its.depth, 0);
  // A cube: no outline; three belts of lines round it.
  const auto cube = mesh_edges({{0, 1, 2, 3},
                                {4, 5, 6, 7},
                                {0, 1, 5, 4},
                                {1, 2, 6, 5},
                                {2, 3, 7, 6},
                                {3, 0, 4, 7}});
  EXPECT_EQ(cube.size(), 12U);
  EXPECT_TRUE(std::ranges::any_of(
      cube, [](const auto& one) { return one.second.depth == 0; }));
  EXPECT_TRUE(mesh_edges({}).empty());
}

// As many elements as cells in either direction: lines stay apart.
TEST(Wireframe, OfAFineMeshCanBeSeenThrough) {
  constexpr int n = 36;
  structure::Deck deck;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= n; ++k) {
      deck.grids.push_back(
          {i * (n + 1) + k, Eigen::Vector3d(0.01 * i, 0.01 * k, 0.0)});
    }
  }
  for (const std::vector<int>& face : plate(n)) {
    structure::Shell shell;
    shell.grids = face;
    deck.shells.push_back(shell);
  }
  deck.grids.front().id = 0;
  Screen screen(36, 18);
  draw_wireframe(screen, screen.area(), wireframe(deck), {}, {0.0, 60.0, 1.0});
  int full = 0;
  for (int y = 0; y < screen.height(); ++y) {
    for (int x = 0; x < screen.width(); ++x) {
      full += screen.at(x, y).glyph == U'⣿' ? 1 : 0;
    }
  }
  EXPECT_EQ(full, 0) << screen.to_text();
}

}  // namespace
}  // namespace tapfit::tui
