// The order of nodes: a middle node lies in the middle of the edge that the
// card of bulk data means by it.
#include "updating/structure/abaqus/element_types.hpp"

#include "tests/updating/support/inp_bricks.hpp"
#include "tests/updating/support/inp_support.hpp"

#include <Eigen/Core>

#include <array>

namespace tapfit::structure {
namespace {

using Edges = std::vector<std::array<std::size_t, 2>>;

void expect_middles(const std::vector<Eigen::Vector3d>& written,
                    const InpType& type,
                    const Edges& edges) {
  ASSERT_EQ(written.size(), type.nodes);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Eigen::Vector3d middle =
        0.5 * (written[type.node_of_grid(edges[k][0] - 1)] +
               written[type.node_of_grid(edges[k][1] - 1)]);
    EXPECT_EQ(written[type.node_of_grid(type.corners + k)], middle)
        << type.card << " G" << type.corners + k + 1;
  }
}

TEST(ElementTypes, MiddlesOfABrick) {
  std::vector<Eigen::Vector3d> at;
  for (const auto& p : brick_nodes) at.emplace_back(p[0], p[1], p[2]);
  // QRG, CHEXA: below, upright, above.
  expect_middles(at,
                 *inp_type("C3D20R"),
                 {{1, 2},
                  {2, 3},
                  {3, 4},
                  {4, 1},
                  {1, 5},
                  {2, 6},
                  {3, 7},
                  {4, 8},
                  {5, 6},
                  {6, 7},
                  {7, 8},
                  {8, 5}});
}

TEST(ElementTypes, MiddlesOfAWedge) {
  const std::vector<Eigen::Vector3d> at{{0, 0, 0},
                                        {2, 0, 0},
                                        {0, 2, 0},
                                        {0, 0, 2},
                                        {2, 0, 2},
                                        {0, 2, 2},
                                        {1, 0, 0},
                                        {1, 1, 0},
                                        {0, 1, 0},
                                        {1, 0, 2},
                                        {1, 1, 2},
                                        {0, 1, 2},
                                        {0, 0, 1},
                                        {2, 0, 1},
                                        {0, 2, 1}};
  expect_middles(
      at,
      *inp_type("C3D15"),
      {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 5}, {3, 6}, {4, 5}, {5, 6}, {6, 4}});
}

TEST(ElementTypes, FacesHaveTheMiddlesOfTheirSides) {
  const InpType& type = *inp_type("C3D20");
  for (int face = 1; face <= 6; ++face) {
    const std::vector<std::size_t> nodes = inp_face(type, face);
    ASSERT_EQ(nodes.size(), 8U);
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(2 * brick_nodes.at(nodes[4 + k]).at(c),
                  brick_nodes.at(nodes[k]).at(c) +
                      brick_nodes.at(nodes[(k + 1) % 4]).at(c));
      }
    }
  }
  // 1, 4, 2 and the middles 8, 9, 5.
  EXPECT_EQ(inp_face(*inp_type("C3D10"), 2),
            (std::vector<std::size_t>{0, 3, 1, 7, 8, 4}));
  // 3, 6, 4, 1 and the middles 15, 12, 13, 9.
  EXPECT_EQ(inp_face(*inp_type("C3D15"), 5),
            (std::vector<std::size_t>{2, 5, 3, 0, 14, 11, 12, 8}));
  EXPECT_EQ(inp_face(*inp_type("C3D6"), 1).size(), 3U);
  EXPECT_EQ(inp_face(*inp_type("C3D6"), 3).size(), 4U);
  EXPECT_TRUE(inp_face(type, 7).empty());
  EXPECT_TRUE(inp_face(*inp_type("B31"), 1).empty());
}

TEST(ElementTypes, UnknownOnesAreNone) {
  EXPECT_EQ(inp_type("CPE8"), nullptr);
  EXPECT_EQ(inp_type("U1"), nullptr);
}

// Regular solids of one element each: the volume is that of the cube's parts.
TEST(ElementTypes, SolidsHaveTheirVolume) {
  const std::string nodes = one_brick().substr(0, one_brick().find("*ELEMENT"));
  const auto mass = [&](const std::string& type, const std::string& line) {
    const Deck deck =
        deck_of_inp(nodes + "*ELEMENT, TYPE=" + type + ", ELSET=V\n1, " + line +
                    "\n" + brick_section);
    const System system = assemble(deck);
    Eigen::VectorXd along_x = Eigen::VectorXd::Zero(system.M.rows());
    for (Eigen::Index k = 0; k < along_x.size(); k += 6) along_x(k) = 1.0;
    return along_x.dot(system.M * along_x);
  };
  EXPECT_NEAR(mass("C3D8R", "1, 2, 3, 4, 5, 6, 7, 8"), 7800.0, 1e-6);
  EXPECT_NEAR(mass("C3D6", "1, 2, 3, 5, 6, 7"), 3900.0, 1e-6);
  EXPECT_NEAR(mass("C3D4", "1, 2, 3, 6"), 1300.0, 1e-6);
}

}  // namespace
}  // namespace tapfit::structure
