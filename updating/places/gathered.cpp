#include "updating/places/gathered.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using Cube = std::array<long, 3>;
using Groups = std::map<Cube, std::vector<std::size_t>>;

Groups in_cubes(const std::vector<Vector3d>& at,
                const Vector3d& corner,
                double edge) {
  Groups groups;
  for (std::size_t k = 0; k < at.size(); ++k) {
    Cube cube{};
    for (Eigen::Index i = 0; i < 3; ++i) {
      cube.at(static_cast<std::size_t>(i)) =
          std::lround(std::floor((at[k](i) - corner(i)) / edge));
    }
    groups[cube].push_back(k);
  }
  return groups;
}

}  // namespace

std::vector<std::vector<std::size_t>> gathered(const std::vector<Vector3d>& at,
                                               std::size_t most) {
  std::vector<std::vector<std::size_t>> result;
  if (at.size() <= most) {
    for (std::size_t k = 0; k < at.size(); ++k) result.push_back({k});
    return result;
  }
  Vector3d low = at.front();
  Vector3d high = at.front();
  for (const Vector3d& x : at) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double whole = std::max((high - low).maxCoeff(), 1e-300);
  // In the middle of what rounding may do to either side of a row of equals.
  const Vector3d corner = low - Vector3d::Constant(1e-6 * whole);
  double few = 1.1 * whole;  // an edge that leaves one cube
  double many = 0.0;
  constexpr int halvings = 24;
  for (int k = 0; k < halvings; ++k) {
    const double edge = 0.5 * (few + many);
    const bool fits = in_cubes(at, corner, edge).size() <= most;
    (fits ? few : many) = edge;
  }
  for (auto& [cube, group] : in_cubes(at, corner, few)) {
    result.push_back(std::move(group));
  }
  std::ranges::sort(result);
  return result;
}

std::vector<std::size_t> spread_out(const std::vector<Vector3d>& at,
                                    std::size_t most) {
  std::vector<std::size_t> result;
  for (const std::vector<std::size_t>& group : gathered(at, most)) {
    Vector3d middle = Vector3d::Zero();
    for (const std::size_t k : group) {
      middle += at[k] / static_cast<double>(group.size());
    }
    result.push_back(*std::ranges::min_element(
        group, {}, [&](std::size_t k) { return (at[k] - middle).norm(); }));
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace tapfit::updating
