#include "updating/places/joint_line.hpp"

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

using Edge = std::array<int, 2>;  // grid ids, ascending

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

// Edges of the shells and the shells (by position) that have them.
using Edges = std::map<Edge, std::vector<std::size_t>>;

Edges edges_of(const Deck& deck) {
  Edges edges;
  for (std::size_t e = 0; e < deck.shells.size(); ++e) {
    const std::vector<int>& grids = deck.shells[e].grids;
    for (std::size_t k = 0; k < grids.size(); ++k) {
      edges[edge_of(grids[k], grids[(k + 1) % grids.size()])].push_back(e);
    }
  }
  return edges;
}

Vector3d at(const Deck& deck, int node) {
  return deck.grids[deck.grid_index(node)].position;
}

// Neighbours along edges between two shells, and grids on a free edge.
struct Net {
  std::map<int, std::vector<int>> inner;
  std::set<int> rim;
};

Net net_of(const Edges& edges) {
  Net net;
  for (const auto& [edge, shells] : edges) {
    if (shells.size() == 2) {
      net.inner[edge[0]].push_back(edge[1]);
      net.inner[edge[1]].push_back(edge[0]);
    } else {
      net.rim.insert(edge.begin(), edge.end());
    }
  }
  return net;
}

// Goes straight on from a to b and beyond until a free edge; nothing where
// the mesh does not go on straight.
std::optional<std::vector<int>> straight_path(const Deck& deck,
                                              const Net& net,
                                              int a,
                                              int b) {
  // A mesh drawn along a line keeps to it well within this.
  const double straight = std::cos(2.0 * M_PI / 180.0);
  std::vector<int> path = {a, b};
  const Vector3d along = (at(deck, b) - at(deck, a)).normalized();
  while (!net.rim.contains(path.back())) {
    int next = 0;
    for (const int c : net.inner.at(path.back())) {
      const Vector3d d = at(deck, c) - at(deck, path.back());
      if (d.dot(along) > straight * d.norm()) next = c;
    }
    if (next == 0) return std::nullopt;
    path.push_back(next);
  }
  return path;
}

// Line through the grids, as a point and a direction.
struct Ray {
  Vector3d from;
  Vector3d along;
  double length = 0.0;
};

Ray ray_of(const Deck& deck, const std::vector<int>& nodes) {
  Ray ray;
  ray.from = at(deck, nodes.front());
  // The first and the farthest from it, then the farthest from that one.
  for (int pass = 0; pass < 2; ++pass) {
    Vector3d far = ray.from;
    for (const int node : nodes) {
      const Vector3d x = at(deck, node);
      if ((x - ray.from).norm() > (far - ray.from).norm()) far = x;
    }
    ray.along = ray.from - far;
    ray.length = ray.along.norm();
    ray.from = far;
  }
  ray.along /= std::max(ray.length, 1e-300);
  return ray;
}

bool on_ray(const Ray& ray, const Vector3d& x) {
  const Vector3d d = x - ray.from;
  const double t = d.dot(ray.along);
  const double slack = 1e-3 * ray.length;
  return t >= -slack && t <= ray.length + slack &&
         (d - t * ray.along).norm() <= slack;
}

bool in_line(const Deck& deck,
             const std::vector<int>& a,
             const std::vector<int>& b) {
  std::vector<int> both = a;
  both.insert(both.end(), b.begin(), b.end());
  const Ray ray = ray_of(deck, both);
  return std::all_of(both.begin(), both.end(), [&](int node) {
    return on_ray(ray, at(deck, node));
  });
}

// Shells on one side of the line: those reached from one another without
// crossing it, one component of the two for every piece of the line.
std::vector<int> one_side(const Deck& deck,
                          const Edges& edges,
                          const std::set<Edge>& line) {
  std::set<int> nodes;
  for (const Edge& edge : line) nodes.insert(edge.begin(), edge.end());
  std::map<std::size_t, std::vector<std::size_t>> beside;
  for (const auto& [edge, shells] : edges) {
    const bool touches = nodes.contains(edge[0]) || nodes.contains(edge[1]);
    if (!touches || line.contains(edge) || shells.size() != 2) continue;
    beside[shells[0]].push_back(shells[1]);
    beside[shells[1]].push_back(shells[0]);
  }
  std::set<std::size_t> side;
  for (const Edge& edge : line) {
    const std::vector<std::size_t>& pair = edges.at(edge);
    if (side.contains(pair[0]) || side.contains(pair[1])) continue;
    std::vector<std::size_t> open = {pair[0]};  // a piece not seen yet
    while (!open.empty()) {
      const std::size_t shell = open.back();
      open.pop_back();
      if (!side.insert(shell).second) continue;
      for (const std::size_t next : beside[shell]) open.push_back(next);
    }
  }
  std::vector<int> ids;
  for (const std::size_t e : side) ids.push_back(deck.shells[e].id);
  return ids;
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
  const Edges edges = edges_of(deck);
  std::set<Edge> line;
  std::map<int, double> length;
  for (const auto& [edge, shells] : edges) {
    const Vector3d a = at(deck, edge[0]);
    const Vector3d b = at(deck, edge[1]);
    if (shells.size() != 2 || !on_ray(ray, a) || !on_ray(ray, b)) continue;
    line.insert(edge);
    for (const int node : edge) length[node] += 0.5 * (b - a).norm();
  }
  JointLine joint;
  for (const auto& [node, part] : length) {
    joint.grids.push_back({node, ray.along, part});
    joint.length += part;
  }
  joint.side = one_side(deck, edges, line);
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
        (at(deck, bar.grids[1]) - at(deck, bar.grids[0])).normalized();
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
