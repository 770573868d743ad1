#include "updating/places/crack_line.hpp"

#include "updating/places/joint_line.hpp"
#include "updating/places/shell_edges.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;
using structure::Shell;

// Of the shells of the side at a grid: their normals' mean and thickness.
struct Faced {
  Vector3d normal = Vector3d::Zero();
  double thickness = 0.0;
  int shells = 0;
};

std::map<int, Faced> faces_of(const Deck& deck, const std::vector<int>& side) {
  const std::set<int> ids(side.begin(), side.end());
  std::map<int, Faced> faces;
  for (const Shell& shell : deck.shells) {
    if (!ids.contains(shell.id)) continue;
    const Vector3d normal = normal_of(deck, shell);
    for (const int node : shell.grids) {
      Faced& face = faces[node];
      face.normal += face.normal.dot(normal) < 0.0 ? -normal : normal;
      face.thickness += thickness_of(deck, shell);
      ++face.shells;
    }
  }
  return faces;
}

}  // namespace

CrackLine crack_line(const Deck& deck, const std::vector<int>& nodes) {
  CrackLine crack;
  if (nodes.size() < 2) return crack;
  const Ray ray = ray_of(deck, nodes);
  const Edges edges = edges_at(deck, ray);
  const Net net = net_of(edges);
  const std::set<Edge> line = edges_on(deck, edges, ray);
  std::map<int, int> beside;
  std::map<int, double> length;
  for (const Edge& edge : line) {
    const double half =
        0.5 *
        (deck.grid(edge[1]).position - deck.grid(edge[0]).position).norm();
    for (const int node : edge) {
      ++beside[node];
      length[node] += half;
    }
  }
  std::set<int> parted;
  for (const auto& [node, count] : beside) {
    if (count == 2 || net.rim.contains(node)) parted.insert(node);
  }
  if (parted.empty()) return crack;
  crack.side = one_side(deck, edges, line, parted);
  for (auto& [node, face] : faces_of(deck, crack.side)) {
    if (!parted.contains(node)) continue;
    const Vector3d normal =
        (face.normal - face.normal.dot(ray.along) * ray.along).normalized();
    const double t = face.thickness / face.shells;
    const double area = length.at(node) * t;
    crack.grids.push_back({node,
                           area,
                           area * t * t / 12.0,
                           {ray.along, normal.cross(ray.along), normal}});
  }
  return crack;
}

std::vector<std::vector<int>> cracks_within(const Deck& deck,
                                            const std::vector<int>& elements) {
  const std::set<int> ids(elements.begin(), elements.end());
  std::set<int> inside;
  for (const Shell& shell : deck.shells) {
    if (!ids.contains(shell.id)) continue;
    inside.insert(shell.grids.begin(), shell.grids.end());
  }
  std::vector<std::vector<int>> cracks;
  if (inside.empty()) return cracks;
  for (const JointPlace& place : joint_places(deck)) {
    std::vector<int> longest;
    std::vector<int> run;
    for (const int node : place.nodes) {
      if (!inside.contains(node)) {
        run.clear();
        continue;
      }
      run.push_back(node);
      if (run.size() > longest.size()) longest = run;
    }
    if (longest.size() > 1) cracks.push_back(std::move(longest));
  }
  return cracks;
}

std::vector<std::vector<int>> cracks_near(const Deck& deck,
                                          const std::vector<int>& nodes) {
  std::vector<std::vector<int>> cracks;
  const auto n = static_cast<std::ptrdiff_t>(nodes.size());
  if (n > 2) {
    cracks.emplace_back(nodes.begin(), nodes.end() - 1);
    cracks.emplace_back(nodes.begin() + 1, nodes.end());
  }
  if (n > 5) {
    cracks.emplace_back(nodes.begin(), nodes.begin() + (n + 1) / 2);
    cracks.emplace_back(nodes.begin() + n / 2, nodes.end());
    cracks.emplace_back(nodes.begin() + n / 4, nodes.end() - n / 4);
  }
  const Net net = net_of(edges_of(deck));
  const Vector3d along =
      (deck.grid(nodes.back()).position - deck.grid(nodes.front()).position)
          .normalized();
  const int on = straight_on(deck, net, nodes.back(), along);
  const int back = straight_on(deck, net, nodes.front(), -along);
  if (on != 0 && !net.rim.contains(nodes.back())) {
    cracks.push_back(nodes);
    cracks.back().push_back(on);
  }
  if (back != 0 && !net.rim.contains(nodes.front())) {
    cracks.push_back(nodes);
    cracks.back().insert(cracks.back().begin(), back);
  }
  return cracks;
}

}  // namespace tapfit::updating
