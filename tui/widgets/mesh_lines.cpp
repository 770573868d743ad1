#include "tui/widgets/mesh_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <numeric>
#include <optional>

namespace tapfit::tui {
namespace {

using Id = std::size_t;

struct Mesh {
  std::map<Edge, Id> ids;
  std::vector<std::vector<std::size_t>> faces_of;  ///< per edge
  std::map<int, std::vector<Id>> edges_at;         ///< per grid
  std::vector<std::array<Id, 2>> opposite;         ///< in a quadrilateral

  Id add(int a, int b, std::size_t face) {
    const Edge edge{std::min(a, b), std::max(a, b)};
    const auto [at, fresh] = ids.try_emplace(edge, ids.size());
    if (fresh) {
      faces_of.emplace_back();
      for (const int grid : edge) edges_at[grid].push_back(at->second);
    }
    faces_of[at->second].push_back(face);
    return at->second;
  }
};

Mesh mesh_of(const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<Id> round;
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      const int a = faces[f][i];
      const int b = faces[f][(i + 1) % faces[f].size()];
      if (a != b) round.push_back(mesh.add(a, b, f));
    }
    if (round.size() != 4) continue;
    mesh.opposite.push_back({round[0], round[2]});
    mesh.opposite.push_back({round[1], round[3]});
  }
  return mesh;
}

bool share_a_face(const Mesh& mesh, Id a, Id b) {
  return std::ranges::any_of(mesh.faces_of[a], [&](std::size_t face) {
    return std::ranges::count(mesh.faces_of[b], face) > 0;
  });
}

/// The one edge that goes on at that grid; none where several may.
std::optional<Id> next_edge(const Mesh& mesh, Id edge, int grid) {
  std::optional<Id> found;
  for (const Id other : mesh.edges_at.at(grid)) {
    if (other == edge || share_a_face(mesh, edge, other)) continue;
    if (found) return std::nullopt;
    found = other;
  }
  return found;
}

/// The line of each edge, named after one of its edges.
class Lines {
 public:
  explicit Lines(const Mesh& mesh) : parent_(mesh.ids.size()) {
    std::iota(parent_.begin(), parent_.end(), Id{0});
    for (const auto& [edge, id] : mesh.ids) {
      for (const int grid : edge) {
        const std::optional<Id> next = next_edge(mesh, id, grid);
        if (next && next_edge(mesh, *next, grid) == id) {
          parent_[of(*next)] = of(id);
        }
      }
    }
  }
  Id of(Id edge) {
    while (parent_[edge] != edge) {
      parent_[edge] = parent_[parent_[edge]];
      edge = parent_[edge];
    }
    return edge;
  }

 private:
  std::vector<Id> parent_;
};

/// Steps from line to line, from those of the outline.
std::vector<int> depths(const Mesh& mesh, Lines& lines) {
  const std::size_t count = mesh.ids.size();
  std::vector<std::vector<Id>> beside(count);
  for (const auto& [a, b] : mesh.opposite) {
    beside[lines.of(a)].push_back(lines.of(b));
    beside[lines.of(b)].push_back(lines.of(a));
  }
  std::vector<int> depth(count, -1);
  std::deque<Id> reached;
  const auto start = [&](Id line) {
    if (depth[line] >= 0) return;
    depth[line] = 0;
    reached.push_back(line);
  };
  const auto spread = [&] {
    for (; !reached.empty(); reached.pop_front()) {
      for (const Id next : beside[reached.front()]) {
        if (depth[next] >= 0) continue;
        depth[next] = depth[reached.front()] + 1;
        reached.push_back(next);
      }
    }
  };
  for (Id edge = 0; edge < count; ++edge) {
    if (mesh.faces_of[edge].size() == 1) start(lines.of(edge));
  }
  spread();
  for (Id edge = 0; edge < count; ++edge) {
    start(lines.of(edge));
    spread();
  }
  return depth;
}

}  // namespace

std::map<Edge, MeshEdge> mesh_edges(
    const std::vector<std::vector<int>>& faces) {
  const Mesh mesh = mesh_of(faces);
  Lines lines(mesh);
  const std::vector<int> depth = depths(mesh, lines);
  std::map<Edge, MeshEdge> edges;
  for (const auto& [edge, id] : mesh.ids) {
    edges[edge] = {depth[lines.of(id)], mesh.faces_of[id].size() == 1};
  }
  return edges;
}

}  // namespace tapfit::tui
