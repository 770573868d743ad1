#include "updating/places/shell_edges.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Vector3d;
using structure::Deck;
using structure::Shell;

Vector3d normal_of(const Deck& deck, const Shell& shell) {
  const auto at = [&](std::size_t k) {
    return deck.grid(shell.grids[k]).position;
  };
  const std::size_t last = shell.grids.size() - 1;
  return (at(2) - at(0)).cross(at(last) - at(1)).normalized();
}

double thickness_of(const Deck& deck, const Shell& shell) {
  return shell.thickness > 0.0
             ? shell.thickness
             : deck.shell_properties.at(shell.property).thickness;
}

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

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

Edges edges_at(const Deck& deck, const Ray& ray) {
  Edges edges;
  std::vector<bool> on;
  for (std::size_t e = 0; e < deck.shells.size(); ++e) {
    const std::vector<int>& grids = deck.shells[e].grids;
    on.clear();
    for (const int grid : grids) {
      on.push_back(on_ray(ray, deck.grid(grid).position));
    }
    for (std::size_t k = 0; k < grids.size(); ++k) {
      const std::size_t next = (k + 1) % grids.size();
      if (on[k] || on[next]) edges[edge_of(grids[k], grids[next])].push_back(e);
    }
  }
  return edges;
}

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

int straight_on(const Deck& deck,
                const Net& net,
                int from,
                const Vector3d& along) {
  // A mesh drawn along a line keeps to it well within this.
  const double straight = std::cos(2.0 * M_PI / 180.0);
  int next = 0;
  const auto inner = net.inner.find(from);
  if (inner == net.inner.end()) return next;
  for (const int c : inner->second) {
    const Vector3d d = deck.grid(c).position - deck.grid(from).position;
    if (d.dot(along) > straight * d.norm()) next = c;
  }
  return next;
}

Ray ray_of(const Deck& deck, const std::vector<int>& nodes) {
  Ray ray;
  ray.from = deck.grid(nodes.front()).position;
  // The first and the farthest from it, then the farthest from that one.
  for (int pass = 0; pass < 2; ++pass) {
    Vector3d far = ray.from;
    for (const int node : nodes) {
      const Vector3d x = deck.grid(node).position;
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

std::set<Edge> edges_on(const Deck& deck, const Edges& edges, const Ray& ray) {
  std::set<Edge> line;
  for (const auto& [edge, shells] : edges) {
    if (shells.size() != 2) continue;
    if (on_ray(ray, deck.grid(edge[0]).position) &&
        on_ray(ray, deck.grid(edge[1]).position)) {
      line.insert(edge);
    }
  }
  return line;
}

std::vector<int> one_side(const Deck& deck,
                          const Edges& edges,
                          const std::set<Edge>& line,
                          const std::set<int>& nodes) {
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

}  // namespace tapfit::updating
