#include "updating/structure/mesh/split_edges.hpp"

#include "updating/structure/deck/constraint_axes.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>

namespace tapfit::structure {
namespace {

Components shared_components(const Components& a, const Components& b) {
  Components both;
  for (const char digit : a) {
    if (b.find(digit) != std::string::npos) both += digit;
  }
  return both;
}

// All three translations, all three rotations: these need no axes.
Components whole_triples(const Components& components) {
  Components whole;
  for (const char* const triple : {"123", "456"}) {
    if (shared_components(triple, components) == triple) whole += triple;
  }
  return whole;
}

// The rotation nearest to the mean of several.
Eigen::Matrix3d mean_axes(const std::vector<Eigen::Matrix3d>& axes) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Matrix3d& one : axes) sum += one;
  if (sum == static_cast<double>(axes.size()) * axes.front()) {
    return axes.front();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d Q = svd.matrixU() * svd.matrixV().transpose();
  return Q.determinant() > 0.0 ? Q : axes.front();
}

// Axes of which the digits mean nearly the same: within 60 degrees.
bool alike(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return (a.transpose() * b).trace() > 2.0;
}

}  // namespace

SplitEdges::SplitEdges(const Deck& deck) {
  mesh_.deck = deck;
  mesh_.deck.shells.clear();
  mesh_.deck.bars.clear();
  mesh_.deck.cards.clear();
  Eigen::AlignedBox3d box;
  for (const Grid& grid : deck.grids) {
    next_grid_ = std::max(next_grid_, grid.id + 1);
    box.extend(grid.position);
  }
  held_ = held_by_grid(deck);
  const double extent = box.isEmpty() ? 0.0 : box.diagonal().norm();
  for (std::size_t k = 0; k < deck.rigids.size(); ++k) see_rigid(k, extent);
  const auto see = [this](const auto& elements) {
    for (const auto& e : elements) {
      next_element_ = std::max(next_element_, e.id + 1);
    }
  };
  see(deck.rigids);
  see(deck.shells);
  see(deck.bars);
  see(deck.rods);
  see(deck.masses);
  see(deck.scalars);
  see(deck.bushes);
  see(deck.solids);
}

// @param extent diagonal of the box around all grids [m]
void SplitEdges::see_rigid(std::size_t k, double extent) {
  const RigidElement& e = mesh_.deck.rigids[k];
  rigid_[e.independent][k] = "123456";
  for (const Dependent& d : e.dependents) {
    rigid_[d.grid][k] = d.components;
    const Eigen::Vector3d apart =
        grid_of(d.grid).position - grid_of(e.independent).position;
    // Coordinates of another system are rounded.
    if (apart.norm() <= 1e-6 * extent) {
      doubles_[d.grid] = {e.independent, d.components};
    }
  }
}

const Grid& SplitEdges::grid_of(int id) const { return mesh_.deck.grid(id); }

int SplitEdges::add_grid(const std::vector<int>& between) {
  Grid grid;
  grid.id = next_grid_++;
  grid.position.setZero();
  std::vector<Eigen::Matrix3d> axes;
  for (const int id : between) {
    const Grid& end = grid_of(id);
    grid.position += end.position;
    axes.push_back(end.axes);
  }
  grid.position /= static_cast<double>(between.size());
  grid.axes = mean_axes(axes);
  mesh_.deck.grids.push_back(grid);
  mesh_.between[grid.id] = between;
  follow(grid, between);
  return grid.id;
}

Components SplitEdges::shared(const Grid& grid,
                              const std::vector<int>& between,
                              const std::function<Components(int)>& of) const {
  Components common = of(between.front());
  for (const int id : between) {
    common = shared_components(common, of(id));
    if (!common.empty() && !alike(grid.axes, grid_of(id).axes)) {
      common = whole_triples(common);
    }
  }
  return common;
}

// Between grids of one rigid body everything is rigid.
void SplitEdges::follow(const Grid& grid, const std::vector<int>& between) {
  const auto bodies = rigid_.find(between.front());
  if (bodies == rigid_.end()) return;
  for (const auto& [k, all] : bodies->second) {
    const std::size_t body = k;
    const Components common = shared(grid, between, [&](int id) {
      const auto ends = rigid_.find(id);
      if (ends == rigid_.end()) return Components();
      const auto end = ends->second.find(body);
      return end == ends->second.end() ? Components() : end->second;
    });
    if (common.empty()) continue;
    mesh_.deck.rigids[body].dependents.push_back({grid.id, common});
  }
}

int SplitEdges::middle(int a, int b) {
  const auto [place, is_new] =
      middles_.try_emplace({std::min(a, b), std::max(a, b)}, 0);
  if (!is_new) return place->second;
  const int id = add_grid({a, b});
  place->second = id;
  const Components both = shared(mesh_.deck.grids.back(), {a, b}, [&](int end) {
    const auto held = held_.find(end);
    return held == held_.end() ? Components() : held->second;
  });
  if (both.empty()) return id;
  mesh_.deck.constraints.push_back({id, both});
  held_edges_.push_back({{a, b}, id});
  return id;
}

}  // namespace tapfit::structure
