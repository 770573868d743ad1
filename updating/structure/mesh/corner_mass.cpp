#include "updating/structure/mesh/corner_mass.hpp"

#include "updating/structure/mesh/member_corners.hpp"
#include "updating/structure/mesh/property_copies.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Vector3d;

bool is_misplaced(const CornerEnd& end) {
  return end.in_through || end.meeting == 2;
}

// What the ends take of each member. Where they overlap, and would leave
// nothing, each takes less.
struct Taken {
  explicit Taken(MemberCorners found) : corners(std::move(found)) {
    std::erase_if(corners.ends,
                  [](const CornerEnd& end) { return !is_misplaced(end); });
    std::map<std::size_t, double> sums;
    for (const CornerEnd& end : corners.ends) {
      for (const auto& [member, share] : end.inside) sums[member] += share;
    }
    for (CornerEnd& end : corners.ends) {
      for (auto& [member, share] : end.inside) {
        share *= std::min(1.0, largest_share / sums.at(member));
        of_member[member] += share;
      }
    }
  }

  MemberCorners corners;
  std::map<std::size_t, double> of_member;
};

// rho A of a bar [kg/m].
double line_density(const Deck& deck, const Bar& bar) {
  const BarProperty& p = deck.bar_properties.at(bar.property);
  const auto material = deck.materials.find(p.material);
  return material == deck.materials.end() ? 0.0 : material->second.rho * p.area;
}

double mass_inside(const Deck& deck,
                   const std::vector<Member>& members,
                   const CornerEnd& end) {
  double mass = 0.0;
  for (const auto& [member, share] : end.inside) {
    const Member& m = members[member];
    mass += share * m.length * line_density(deck, deck.bars[m.bar]);
  }
  return mass;
}

// The block of two ends at a grid, as heavy as what is taken off their bars.
PointMass corner_block(const std::vector<Member>& members,
                       const CornerEnd& a,
                       const CornerEnd& b,
                       double mass) {
  const Vector3d n = a.along.cross(b.along).normalized();
  Eigen::Matrix3d axes;
  axes << a.along, n.cross(a.along), n;
  const double across = members[a.own].reach(n) + members[b.own].reach(n);
  const Vector3d square =
      Vector3d(2.0 * a.length, 2.0 * b.length, across).cwiseAbs2();
  PointMass block;
  block.grid = a.grid;
  block.mass = mass;
  block.inertia =
      axes *
      (mass / 12.0 * (Vector3d::Constant(square.sum()) - square)).asDiagonal() *
      axes.transpose();
  return block;
}

std::vector<PointMass> corner_blocks(const Deck& deck, const Taken& taken) {
  const MemberCorners& corners = taken.corners;
  std::map<int, std::vector<const CornerEnd*>> at_grid;
  for (const CornerEnd& end : corners.ends) {
    if (!end.in_through) at_grid[end.grid].push_back(&end);
  }
  std::vector<PointMass> blocks;
  for (const auto& [grid, two] : at_grid) {
    if (two.size() != 2) continue;
    const double mass = mass_inside(deck, corners.members, *two[0]) +
                        mass_inside(deck, corners.members, *two[1]);
    if (mass > 0.0) {
      blocks.push_back(corner_block(corners.members, *two[0], *two[1], mass));
    }
  }
  return blocks;
}

}  // namespace

std::map<int, double> misplaced_mass(const Deck& deck) {
  const Taken taken(member_corners(deck));
  std::map<int, double> shares;
  for (const auto& [member, share] : taken.of_member) {
    shares[deck.bars[taken.corners.members[member].bar].id] = share;
  }
  return shares;
}

Deck with_placed_mass(Deck deck) {
  const Taken taken(member_corners(deck));
  std::vector<PointMass> blocks = corner_blocks(deck, taken);
  int id = 0;
  for (const PointMass& mass : deck.masses) id = std::max(id, mass.id);
  for (PointMass& block : blocks) {
    block.id = ++id;
    deck.masses.push_back(std::move(block));
  }
  PropertyCopies lighter;
  for (const auto& [member, share] : taken.of_member) {
    Bar& bar = deck.bars[taken.corners.members[member].bar];
    const double left = 1.0 - share;
    bar.property = lighter.of(bar.property, left, [&](int property) {
      BarProperty& p = copied(deck.bar_properties, property);
      if (deck.materials.contains(p.material)) {
        Material& m = copied(deck.materials, p.material);
        m.rho *= left;
        p.material = m.id;
      }
      return p.id;
    });
  }
  return deck;
}

}  // namespace tapfit::structure
