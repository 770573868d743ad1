#include "acquisition/uff/write_uff_geometry.hpp"

#include "acquisition/uff/uff_header.hpp"
#include "acquisition/uff/uff_systems.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>

namespace tapfit::acquisition {
namespace {

int displacement_system(const UffGeometry& geometry, int node) {
  const auto found = geometry.node_systems.find(node);
  return found == geometry.node_systems.end() ? 0 : found->second.displacement;
}

// Rows x, y, z and the origin, in global axes.
void write_systems(const UffGeometry& geometry, std::ostream& out) {
  if (geometry.systems.empty()) return;
  fmt::print(out, "{}{:6}\n{:10}\ntest\n", uff_fence, 2420, 1);
  for (const auto& [label, unused] : geometry.systems) {
    const CoordinateSystem system =
        system_of(geometry, label, "a universal file");
    fmt::print(out,
               "{:10}{:10}{:10}\nCS{}\n",
               label,
               static_cast<int>(system.kind),
               8,
               label);
    Eigen::Matrix<double, 4, 3> rows;
    rows << system.axes.transpose(), system.origin.transpose();
    for (const auto& row : rows.rowwise()) {
      std::string line =
          fmt::format("{:25.16E}{:25.16E}{:25.16E}", row(0), row(1), row(2));
      std::replace(line.begin(), line.end(), 'E', 'D');
      out << line << '\n';
    }
  }
  out << uff_fence;
}

// Coordinates are global (0). Six digits move a point by 5e-6 of its distance.
void write_nodes_15(const UffGeometry& geometry, std::ostream& out) {
  fmt::print(out, "{}{:6}\n", uff_fence, 15);
  for (const auto& [label, x] : geometry.nodes) {
    fmt::print(out,
               "{:10}{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n",
               label,
               0,
               displacement_system(geometry, label),
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
    const int along = displacement_system(geometry, label);
    fmt::print(
        out, "{:10}{:10}{:10}{:10}\n", label, 1, along == 0 ? 1 : along, 11);
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
  write_systems(geometry, out);
  if (as == UffNodes::D15) {
    write_nodes_15(geometry, out);
  } else {
    write_nodes_2411(geometry, out);
  }
  if (!geometry.trace_lines.empty()) write_trace_lines(geometry, out);
}

}  // namespace tapfit::acquisition
