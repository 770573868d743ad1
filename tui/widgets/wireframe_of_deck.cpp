// The lines that a deck is drawn by.
#include "tui/widgets/wireframe.hpp"
#include "updating/structure/elements/solid_shapes.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <algorithm>
#include <set>

namespace tapfit::tui {
namespace {

constexpr std::size_t most_edges = 3000;

constexpr int line_element = 1000;  // told apart from shared shell edges

struct EdgeCollector {
  const Wireframe& wire;
  std::map<Edge, int> uses;

  void add(int a, int b, int weight) {
    const auto i = wire.index.find(a);
    const auto j = wire.index.find(b);
    if (i == wire.index.end() || j == wire.index.end()) return;
    if (i->second == j->second) return;
    uses[{std::min(i->second, j->second), std::max(i->second, j->second)}] +=
        weight;
  }
};

/// A line between grids that given matrices couple; none where (as in condensed
/// models) nearly each is coupled to all.
void add_couplings(const structure::Deck& deck, EdgeCollector& edges) {
  constexpr std::size_t most_neighbours = 13;  // half of a solid's 26
  std::set<Edge> couplings;
  const Eigen::SparseMatrix<double>& K = deck.given->K;
  for (Eigen::Index c = 0; c < K.outerSize(); ++c) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, c); it; ++it) {
      const auto row = static_cast<int>(it.row() / 6);
      const auto column = static_cast<int>(c / 6);
      if (row < column) couplings.insert({row, column});
    }
  }
  if (couplings.size() > most_neighbours * deck.grids.size()) return;
  for (const auto& [a, b] : couplings) {
    edges.add(deck.grids[static_cast<std::size_t>(a)].id,
              deck.grids[static_cast<std::size_t>(b)].id,
              line_element);
  }
}

/// Shells as indices of their grids.
std::vector<std::vector<int>> faces_of(const structure::Deck& deck,
                                       const Wireframe& wire) {
  std::vector<std::vector<int>> faces;
  for (const structure::Shell& shell : deck.shells) {
    faces.emplace_back();
    for (const int grid : shell.grids) {
      const auto found = wire.index.find(grid);
      if (found != wire.index.end()) faces.back().push_back(found->second);
    }
  }
  return faces;
}

}  // namespace

Wireframe wireframe(const structure::Deck& deck) {
  Wireframe wire;
  wire.points.resize(3, static_cast<Eigen::Index>(deck.grids.size()));
  for (std::size_t i = 0; i < deck.grids.size(); ++i) {
    wire.points.col(static_cast<Eigen::Index>(i)) = deck.grids[i].position;
    wire.index[deck.grids[i].id] = static_cast<int>(i);
  }
  for (const structure::MeasuringPoint& point : deck.measuring) {
    wire.axes[point.grid] = point.axes;
  }
  EdgeCollector edges{wire, {}};
  for (const structure::Shell& shell : deck.shells) {
    for (std::size_t i = 0; i < shell.grids.size(); ++i) {
      edges.add(shell.grids[i], shell.grids[(i + 1) % shell.grids.size()], 1);
    }
  }
  for (const structure::Solid& solid : deck.solids) {
    for (const auto& [a, b] : structure::solid_edges(solid.grids.size())) {
      edges.add(solid.grids[static_cast<std::size_t>(a)],
                solid.grids[static_cast<std::size_t>(b)],
                1);
    }
  }
  for (const auto& bar : deck.bars) {
    edges.add(bar.grids[0], bar.grids[1], line_element);
  }
  for (const auto& rod : deck.rods) {
    edges.add(rod.grids[0], rod.grids[1], line_element);
  }
  for (const auto& rigid : deck.rigids) {
    for (const auto& follower : rigid.dependents) {
      edges.add(rigid.independent, follower.grid, line_element);
    }
  }
  for (const auto& line : deck.plot_lines) {
    edges.add(line[0], line[1], line_element);
  }
  if (deck.given) add_couplings(deck, edges);
  const bool outline = edges.uses.size() > most_edges;
  const std::map<Edge, MeshEdge> mesh = mesh_edges(faces_of(deck, wire));
  for (const auto& [edge, uses] : edges.uses) {
    if (outline && uses != 1 && uses < line_element) continue;
    const auto at = mesh.find(edge);
    const bool shell = uses < line_element && at != mesh.end();
    wire.lines.push_back(edge);
    wire.ranks.push_back(shell ? at->second : MeshEdge{0, true});
  }
  return wire;
}

}  // namespace tapfit::tui
