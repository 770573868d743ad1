#include "acquisition/uff/uff_geometry.hpp"

#include "acquisition/uff/uff_lines.hpp"

#include <algorithm>
#include <array>

namespace tapfit::acquisition {
namespace {

void take_systems(int node,
                  const UffNodeSystems& systems,
                  UffGeometry& geometry) {
  geometry.node_systems.erase(node);
  if (systems.definition == 0 && systems.displacement == 0) return;
  geometry.node_systems[node] = systems;
}

void add_nodes_15(UffLines lines,
                  const std::string& place,
                  UffGeometry& geometry) {
  while (!lines.only_blanks_left()) {
    const std::vector<double> v = lines.mixed(4, 13, 3);
    const int node = as_integer(v[0]);
    geometry.nodes[node] = {v[4], v[5], v[6]};
    take_systems(node, {as_integer(v[1]), as_integer(v[2]), place}, geometry);
  }
}

// The second number is the system that coordinates were shown in; they are
// global all the same.
void add_nodes_2411(UffLines lines,
                    const std::string& place,
                    UffGeometry& geometry) {
  while (!lines.only_blanks_left()) {
    const std::vector<int> head = lines.integers(1);
    const std::vector<double> x = lines.numbers(25, 3);
    geometry.nodes[head[0]] = {x[0], x[1], x[2]};
    take_systems(head[0], {0, head.size() > 2 ? head[2] : 0, place}, geometry);
  }
}

void add_trace_line(UffLines lines, UffGeometry& geometry) {
  const auto count =
      static_cast<std::size_t>(std::clamp(lines.integers(2)[1], 0, 1 << 24));
  (void)lines.text();
  std::vector<int> piece;
  const auto lift = [&] {
    if (piece.size() > 1) geometry.trace_lines.push_back(piece);
    piece.clear();
  };
  for (const int node : lines.many_integers(count)) {
    if (node == 0) {
      lift();
    } else {
      piece.push_back(node);
    }
  }
  lift();
}

bool is_beam(int kind) {
  constexpr std::array<int, 5> beams{11, 21, 22, 23, 24};
  return std::find(beams.begin(), beams.end(), kind) != beams.end();
}

void add_elements(UffLines lines, UffGeometry& geometry) {
  while (!lines.only_blanks_left()) {
    const std::vector<int> header = lines.integers(6);
    UffElement element{header[0], header[1], {}};
    if (is_beam(element.kind)) (void)lines.text();
    const auto count =
        static_cast<std::size_t>(std::clamp(header[5], 0, 1 << 10));
    element.nodes = lines.many_integers(count);
    geometry.elements.push_back(std::move(element));
  }
}

}  // namespace

void add_geometry(const UffDataset& dataset, UffGeometry& geometry) {
  const UffLines lines(dataset);
  if (dataset.type == 15) add_nodes_15(lines, dataset.place, geometry);
  if (dataset.type == 2411) add_nodes_2411(lines, dataset.place, geometry);
  if (dataset.type == 82) add_trace_line(lines, geometry);
  if (dataset.type == 2412) add_elements(lines, geometry);
}

}  // namespace tapfit::acquisition
