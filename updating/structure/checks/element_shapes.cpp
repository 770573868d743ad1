#include "updating/structure/checks/element_shapes.hpp"

#include "updating/structure/cards/listed.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::structure {
namespace {

using Corner = Eigen::Vector3d;

// Corners of a quadrilateral lie in turn above and below its mean plane, all as
// far: half of what the diagonals pass each other by.
double warp(const std::vector<Corner>& corners) {
  if (corners.size() != 4) return 0.0;
  const Corner d1 = corners[2] - corners[0];
  const Corner d2 = corners[3] - corners[1];
  const Corner normal = d1.cross(d2).normalized();
  const double height = 0.5 * std::abs(normal.dot(corners[1] - corners[0]));
  return height / (0.5 * (d1.norm() + d2.norm()));
}

double edge_ratio(const std::vector<Corner>& corners) {
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double edge = (corners[(k + 1) % corners.size()] - corners[k]).norm();
    shortest = std::min(shortest, edge);
    longest = std::max(longest, edge);
  }
  return longest / shortest;
}

}  // namespace

std::vector<std::string> element_shape_warnings(const Deck& deck) {
  // The usual limit of solvers' own checks of a quadrilateral's warp.
  constexpr double warped_from = 0.05;
  // No mesh is drawn like that; the element still carries it.
  constexpr double short_from = 100.0;
  std::vector<std::string> warped;
  std::vector<std::string> short_edged;
  for (const Shell& shell : deck.shells) {
    const std::vector<Corner> corners = deck.positions(shell.grids);
    const auto place = [&] {
      return card_place(deck, shell.where, fmt::format("shell {}", shell.id));
    };
    if (warp(corners) > warped_from) warped.push_back(place());
    if (edge_ratio(corners) > short_from) short_edged.push_back(place());
  }
  std::vector<std::string> texts;
  if (!warped.empty()) {
    texts.push_back(fmt::format(
        "{}: corners stand more than {:.0f} % of the diagonal off the mean "
        "plane, and the element is taken as flat; check its grids, or split "
        "it into triangles",
        listed(warped),
        100.0 * warped_from));
  }
  if (!short_edged.empty()) {
    texts.push_back(
        fmt::format("{}: an edge is less than 1/{:.0f} of the longest; check "
                    "whether two grids should be one",
                    listed(short_edged),
                    short_from));
  }
  return texts;
}

}  // namespace tapfit::structure
