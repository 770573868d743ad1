#include "updating/places/axial_member.hpp"

#include "updating/places/bars_in_line.hpp"
#include "updating/places/shell_edges.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// Of a sheet's length, how near to its farthest grid its end reaches: less than
// an element of all but the coarsest meshes.
constexpr double end_zone = 0.02;
// Cosine of the sharpest fold within a sheet, 20 degrees.
constexpr double nearly_flat = 0.94;
// Of the second moments of a sheet: its sides are within a hundredth.
constexpr double nearly_square = 0.98;

// Whether something besides the elements named holds any of the grids, or is
// joined to it.
bool is_held(const Deck& deck,
             const std::set<int>& own,
             const std::set<int>& ends) {
  const auto any = [&ends](const auto& grids) {
    return std::ranges::any_of(
        grids, [&ends](int grid) { return ends.contains(grid); });
  };
  const auto joined = [&](const auto& elements) {
    return std::ranges::any_of(elements, [&](const auto& e) {
      return any(e.grids) && !own.contains(e.id);
    });
  };
  if (joined(deck.shells) || joined(deck.bars) || joined(deck.rods) ||
      joined(deck.solids) || joined(deck.scalars) || joined(deck.bushes)) {
    return true;
  }
  for (const auto& rigid : deck.rigids) {
    if (ends.contains(rigid.independent)) return true;
    for (const auto& d : rigid.dependents) {
      if (ends.contains(d.grid)) return true;
    }
  }
  for (const auto& relation : deck.relations) {
    // Points of the test follow the structure and hold nothing.
    if (relation.grid < 0) continue;
    if (ends.contains(relation.grid)) return true;
    for (const auto& term : relation.terms) {
      if (ends.contains(term.grid)) return true;
    }
  }
  return std::ranges::any_of(deck.constraints, [&ends](const auto& c) {
    return ends.contains(c.grid) &&
           c.components.find_first_of("123") != std::string::npos;
  });
}

// The grids at the two ends of lines of elements; empty where there are not
// two.
std::vector<int> line_ends(const Deck& deck, const std::set<int>& own) {
  std::map<int, int> count;
  const auto take = [&](const auto& elements) {
    for (const auto& e : elements) {
      if (!own.contains(e.id)) continue;
      for (const int grid : e.grids) ++count[grid];
    }
  };
  take(deck.bars);
  take(deck.rods);
  std::vector<int> ends;
  for (const auto& [grid, times] : count) {
    if (times > 2) return {};
    if (times == 1) ends.push_back(grid);
  }
  return ends.size() == 2 ? ends : std::vector<int>{};
}

// Positions of the shells' grids.
std::map<int, Vector3d> sheet_grids(const Deck& deck,
                                    const std::set<int>& own) {
  std::map<int, Vector3d> grids;
  for (const structure::Shell& shell : deck.shells) {
    if (!own.contains(shell.id)) continue;
    for (const int grid : shell.grids) grids[grid] = deck.grid(grid).position;
  }
  return grids;
}

// The principal direction of a sheet's area that is longest, or across it: the
// same however it is meshed.
Vector3d principal_axis(const Deck& deck,
                        const std::set<int>& own,
                        bool across) {
  double area = 0.0;
  Vector3d first = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const structure::Shell& shell : deck.shells) {
    if (!own.contains(shell.id)) continue;
    std::vector<Vector3d> x;
    Vector3d middle = Vector3d::Zero();
    for (const int grid : shell.grids) {
      x.push_back(deck.grid(grid).position);
      middle += x.back() / static_cast<double>(shell.grids.size());
    }
    const double part = (x.size() == 4 ? (x[2] - x[0]).cross(x[3] - x[1])
                                       : (x[1] - x[0]).cross(x[2] - x[0]))
                            .norm() /
                        2.0;
    area += part;
    first += part * middle;
    second += part * middle * middle.transpose();
    // Exact for triangles and parallelograms.
    for (const Vector3d& corner : x) {
      second += part / 12.0 * (corner - middle) * (corner - middle).transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      second - first * first.transpose() / area);
  const Vector3d normal = solver.eigenvectors().col(0);
  Vector3d along = solver.eigenvectors().col(2);
  // A square has no longest direction: the first basic axis that lies in it.
  if (solver.eigenvalues()(1) > nearly_square * solver.eigenvalues()(2)) {
    for (const Eigen::Index k : {2, 1, 0}) {
      const Vector3d axis = Vector3d::Unit(k);
      const Vector3d in_plane = axis - normal * normal.dot(axis);
      if (in_plane.norm() > 0.5) along = in_plane.normalized();
    }
  }
  return across ? Vector3d(normal.cross(along)) : along;
}

std::optional<AxialMember> sheet_member(const std::map<int, Vector3d>& grids,
                                        const Vector3d& axis) {
  AxialMember member;
  member.axis = axis;
  double low = 1e300;
  double high = -1e300;
  for (const auto& [grid, x] : grids) {
    low = std::min(low, member.axis.dot(x));
    high = std::max(high, member.axis.dot(x));
  }
  member.length = high - low;
  if (!(member.length > 0.0)) return std::nullopt;
  for (const auto& [grid, x] : grids) {
    const double at = (member.axis.dot(x) - low) / member.length;
    if (at < end_zone) member.ends[0].grids.push_back(grid);
    if (at > 1.0 - end_zone) member.ends[1].grids.push_back(grid);
  }
  return member;
}

// Shells of one sheet with the first.
std::vector<int> sheet_from(const Deck& deck,
                            const std::vector<std::set<std::size_t>>& beside,
                            std::size_t first,
                            std::set<std::size_t>& left) {
  std::vector<std::size_t> open = {first};
  std::vector<int> ids;
  left.erase(first);
  while (!open.empty()) {
    const std::size_t k = open.back();
    open.pop_back();
    ids.push_back(deck.shells[k].id);
    const Vector3d normal = normal_of(deck, deck.shells[k]);
    for (const std::size_t other : beside[k]) {
      if (!left.contains(other)) continue;
      const double fold =
          std::abs(normal.dot(normal_of(deck, deck.shells[other])));
      if (fold < nearly_flat) continue;
      left.erase(other);
      open.push_back(other);
    }
  }
  std::ranges::sort(ids);
  return ids;
}

std::vector<std::vector<int>> sheets(const Deck& deck) {
  std::vector<std::set<std::size_t>> beside(deck.shells.size());
  for (const auto& [edge, shells] : edges_of(deck)) {
    // Where three meet each goes its own way.
    if (shells.size() != 2) continue;
    beside[shells[0]].insert(shells[1]);
    beside[shells[1]].insert(shells[0]);
  }
  std::set<std::size_t> left;
  for (std::size_t k = 0; k < deck.shells.size(); ++k) left.insert(k);
  std::vector<std::vector<int>> result;
  while (!left.empty()) {
    result.push_back(sheet_from(deck, beside, *left.begin(), left));
  }
  return result;
}

}  // namespace

const MemberEnd* AxialMember::pulled() const {
  const auto loose = std::ranges::find(ends, true, &MemberEnd::loose);
  return loose == ends.end() ? nullptr : &*loose;
}

std::optional<AxialMember> axial_member(const Deck& deck,
                                        const std::vector<int>& elements,
                                        bool across) {
  const std::set<int> own(elements.begin(), elements.end());
  std::optional<AxialMember> member;
  const std::map<int, Vector3d> grids = sheet_grids(deck, own);
  if (!grids.empty()) {
    member = sheet_member(grids, principal_axis(deck, own, across));
  } else if (const std::vector<int> ends = line_ends(deck, own);
             !ends.empty() && !across) {
    const Vector3d side =
        deck.grid(ends[1]).position - deck.grid(ends[0]).position;
    member.emplace();
    member->length = side.norm();
    member->axis = side.normalized();
    for (const std::size_t k : {0U, 1U}) member->ends.at(k).grids = {ends[k]};
  }
  if (!member || !(member->length > 0.0)) return std::nullopt;
  for (MemberEnd& end : member->ends) {
    end.loose = !is_held(deck, own, {end.grids.begin(), end.grids.end()});
  }
  return member;
}

std::vector<std::vector<int>> whole_members(const Deck& deck) {
  std::vector<std::vector<int>> members = whole_runs(deck);
  for (const structure::Rod& rod : deck.rods) members.push_back({rod.id});
  for (std::vector<int>& sheet : sheets(deck)) {
    members.push_back(std::move(sheet));
  }
  return members;
}

}  // namespace tapfit::updating
