#include "acquisition/uff/uff_geometry.hpp"

#include "acquisition/uff/uff_header.hpp"
#include "acquisition/uff/uff_lines.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <ostream>

namespace tapfit::acquisition {
namespace {

void add_nodes_15(UffLines lines, UffGeometry& geometry) {
  while (!lines.only_blanks_left()) {
    const std::vector<double> v = lines.mixed(4, 13, 3);
    geometry.nodes[as_integer(v[0])] = {v[4], v[5], v[6]};
  }
}

void add_nodes_2411(UffLines lines, UffGeometry& geometry) {
  while (!lines.only_blanks_left()) {
    const int node = lines.integers(1)[0];
    const std::vector<double> x = lines.numbers(25, 3);
    geometry.nodes[node] = {x[0], x[1], x[2]};
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

// Global axes throughout (0). Six digits move a point by 5e-6 of its distance.
void write_nodes_15(const UffGeometry& geometry, std::ostream& out) {
  fmt::print(out, "{}{:6}\n", uff_fence, 15);
  for (const auto& [label, x] : geometry.nodes) {
    fmt::print(out,
               "{:10}{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n",
               label,
               0,
               0,
               11,
               x[0],
               x[1],
               x[2]);
  }
  out << uff_fence;
}

void write_nodes_2411(const UffGeometry& geometry, std::ostream& out) {
  fmt::print(out, "{}{:6}\n", uff_fence, 2411);
  for (const auto& [label, x] : geometry.nodes) {
    fmt::print(out, "{:10}{:10}{:10}{:10}\n", label, 1, 1, 11);
    std::string line =
        fmt::format("{:25.16E}{:25.16E}{:25.16E}", x[0], x[1], x[2]);
    std::replace(line.begin(), line.end(), 'E', 'D');
    out << line << '\n';
  }
  out << uff_fence;
}

// All pieces as one line, the pen lifted between them.
void write_trace_lines(const UffGeometry& geometry, std::ostream& out) {
  std::vector<int> nodes;
  for (const std::vector<int>& piece : geometry.trace_lines) {
    if (!nodes.empty()) nodes.push_back(0);
    nodes.insert(nodes.end(), piece.begin(), piece.end());
  }
  fmt::print(out,
             "{}{:6}\n{:10}{:10}{:10}\nlines of the model\n",
             uff_fence,
             82,
             1,
             nodes.size(),
             11);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    fmt::print(out, "{:10}", nodes[i]);
    if (i % 8 == 7 || i + 1 == nodes.size()) out << '\n';
  }
  out << uff_fence;
}

}  // namespace

void write_geometry(const UffGeometry& geometry,
                    UffNodes as,
                    std::ostream& out) {
  if (geometry.nodes.empty()) return;
  if (as == UffNodes::D15) {
    write_nodes_15(geometry, out);
  } else {
    write_nodes_2411(geometry, out);
  }
  if (!geometry.trace_lines.empty()) write_trace_lines(geometry, out);
}

void add_geometry(const UffDataset& dataset, UffGeometry& geometry) {
  const UffLines lines(dataset);
  if (dataset.type == 15) add_nodes_15(lines, geometry);
  if (dataset.type == 2411) add_nodes_2411(lines, geometry);
  if (dataset.type == 82) add_trace_line(lines, geometry);
  if (dataset.type == 2412) add_elements(lines, geometry);
}

}  // namespace tapfit::acquisition
