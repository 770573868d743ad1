#include "updating/places/joint_line.hpp"

#include "updating/places/shell_edges.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

// Goes straight on from a to b and beyond until a free edge; nothing where
// the mesh does not go on straight.
std::optional<std::vector<int>> straight_path(const Deck& deck,
                                              const Net& net,
                                              int a,
                                              int b) {
  std::vector<int> path = {a, b};
  const Vector3d along =
      (deck.grid(b).position - deck.grid(a).position).normalized();
  while (!net.rim.contains(path.back())) {
    const int next = straight_on(deck, net, path.back(), along);
    if (next == 0) return std::nullopt;
    path.push_back(next);
  }
  return path;
}

bool in_line(const Deck& deck,
             const std::vector<int>& a,
             const std::vector<int>& b) {
  std::vector<int> both = a;
  both.insert(both.end(), b.begin(), b.end());
  const Ray ray = ray_of(deck, both);
  return std::all_of(both.begin(), both.end(), [&](int node) {
    return on_ray(ray, deck.grid(node).position);
  });
}

std::vector<JointPlace> bar_places(const Deck& deck) {
  std::map<int, std::vector<int>> bars;
  for (const structure::Bar& bar : deck.bars) {
    for (const int node : bar.grids) bars[node].push_back(bar.id);
  }
  std::vector<JointPlace> places;
  for (const auto& [node, ids] : bars) {
    if (ids.size() == 2) places.push_back({{node}, 0});
    if (ids.size() < 3) continue;
    for (const int id : ids) places.push_back({{node}, id});
  }
  return places;
}

}  // namespace

std::vector<JointPlace> joint_places(const Deck& deck) {
  const Edges edges = edges_of(deck);
  const Net net = net_of(edges);
  std::vector<JointPlace> places;
  std::set<std::set<int>> seen;
  for (const int start : net.rim) {
    const auto it = net.inner.find(start);
    if (it == net.inner.end()) continue;
    for (const int next : it->second) {
      const auto path = straight_path(deck, net, start, next);
      if (!path) continue;
      if (!seen.insert({path->begin(), path->end()}).second) continue;
      places.push_back({*path, 0});
    }
  }
  const std::size_t single = places.size();
  std::vector<bool> taken(single, false);
  for (std::size_t a = 0; a < single; ++a) {
    if (taken[a]) continue;
    JointPlace together = places[a];
    for (std::size_t b = a + 1; b < single; ++b) {
      if (taken[b] || !in_line(deck, together.nodes, places[b].nodes)) continue;
      taken[b] = true;
      together.nodes.insert(
          together.nodes.end(), places[b].nodes.begin(), places[b].nodes.end());
    }
    if (together.nodes.size() > places[a].nodes.size()) {
      places.push_back(together);
    }
  }
  const std::vector<JointPlace> bars = bar_places(deck);
  places.insert(places.end(), bars.begin(), bars.end());
  return places;
}

JointLine shell_joint(const Deck& deck, const std::vector<int>& nodes) {
  const Ray ray = ray_of(deck, nodes);
  const Edges edges = edges_at(deck, ray);
  const std::set<Edge> line = edges_on(deck, edges, ray);
  std::set<int> grids;
  std::map<int, double> length;
  for (const Edge& edge : line) {
    grids.insert(edge.begin(), edge.end());
    const double half =
        0.5 *
        (deck.grid(edge[1]).position - deck.grid(edge[0]).position).norm();
    for (const int node : edge) length[node] += half;
  }
  JointLine joint;
  for (const auto& [node, part] : length) {
    joint.grids.push_back({node, ray.along, part});
    joint.length += part;
  }
  joint.side = one_side(deck, edges, line, grids);
  return joint;
}

int across_bar(const Deck& deck,
               int node,
               const std::vector<int>& bars,
               const std::vector<int>& components) {
  const auto across = std::ranges::find_if(components, [&](int component) {
    return !bar_joint(deck, node, bars, component).grids.empty();
  });
  return across == components.end() ? components.front() : *across;
}

JointLine bar_joint(const Deck& deck,
                    int node,
                    const std::vector<int>& bars,
                    int component) {
  JointLine joint;
  for (const structure::Bar& bar : deck.bars) {
    const bool touches = bar.grids[0] == node || bar.grids[1] == node;
    const bool wanted =
        bars.empty() ||
        std::find(bars.begin(), bars.end(), bar.id) != bars.end();
    if (!touches || !wanted) continue;
    const Vector3d along =
        (deck.grid(bar.grids[1]).position - deck.grid(bar.grids[0]).position)
            .normalized();
    const Vector3d axis = along.cross(Vector3d::Unit(component - 1));
    if (axis.norm() < 1e-3) return joint;
    joint.grids.push_back({node, axis.normalized(), 1.0});
    joint.side = {bar.id};
    joint.length = 1.0;
    return joint;
  }
  return joint;
}

}  // namespace tapfit::updating
