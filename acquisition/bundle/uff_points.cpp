#include "acquisition/bundle/uff_points.hpp"

#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/csv_table.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "acquisition/uff/uff_units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace tapfit::acquisition {
namespace {

// A table's label.
bool is_node_label(int label) {
  return label >= 1 && node_of_uff_label(label) == label;
}

// Behind the last label are points of the test's own in a file of tapfit's
// (uff_label), by the numbers that they have there.
int own_number(int label) { return std::abs(node_of_uff_label(label)); }

InputError no_label(const std::string& said,
                    const std::filesystem::path& file) {
  return {fmt::format("\"{}\" is no label of a point", said),
          file.filename().string(),
          "number the points from 1 to at most 100000000; in a table each has "
          "one line: label, x, y, z"};
}

TestGeometry geometry_of_uff(const std::filesystem::path& path) {
  const UffFile file = open_uff(path);
  const UffMesh mesh =
      file.bytes.reading([&] { return read_uff_mesh(file.datasets); });
  TestGeometry result;
  for (const auto& [label, unused] : mesh.geometry.nodes) {
    if (label < 1) throw no_label(std::to_string(label), path);
    const int number = own_number(label);
    const Eigen::Vector3d at =
        mesh.length_m * position_of(mesh.geometry, label);
    if (!result.nodes.try_emplace(number, at).second) {
      throw InputError(
          fmt::format(
              "nodes {} and {} are both point {}", number, label, number),
          path.filename().string(),
          "take \"geometry\" out of test.json: labels above 100000000 are "
          "points with coordinates of their own, the others grids");
    }
    const Eigen::Matrix3d axes = directions_at(mesh.geometry, label);
    if (!axes.isIdentity(1e-12)) result.directions[number] = axes;
  }
  return result;
}

TestGeometry geometry_of_table(const std::filesystem::path& path,
                               double length_m) {
  const Eigen::MatrixXd table =
      read_csv_columns(path, {"1", "2", "3", "4"}, CsvOptions{});
  TestGeometry result;
  for (Eigen::Index i = 0; i < table.rows(); ++i) {
    const double label = table(i, 0);
    const bool whole = label == std::round(label) && label >= 1.0 &&
                       label <= std::numeric_limits<int>::max();
    const int number = whole ? static_cast<int>(label) : 0;
    if (!is_node_label(number)) throw no_label(fmt::format("{}", label), path);
    const Eigen::Vector3d at =
        length_m * table.row(i).segment<3>(1).transpose();
    if (result.nodes.try_emplace(number, at).second) continue;
    throw InputError(fmt::format("point {} is there twice", number),
                     path.filename().string(),
                     "give each point one line: label, x, y, z");
  }
  return result;
}

}  // namespace

UffMesh read_uff_mesh(const std::vector<UffDataset>& file) {
  UffMesh mesh{read_geometry(file)};
  for (const UffDataset& dataset : file) {
    if (dataset.type != 164) continue;
    mesh.length_m = 1.0 / read_uff_units(dataset).length;
  }
  return mesh;
}

std::vector<TestPoint> own_points(const UffMesh& mesh,
                                  const std::string& name) {
  std::vector<TestPoint> points;
  for (const auto& [label, unused] : mesh.geometry.nodes) {
    const int node = node_of_uff_label(label);
    const auto axes = skew_axes(mesh.geometry, label);
    if (node > 0 && !axes) continue;
    TestPoint point;
    point.label = node < 0 ? -node : node;
    if (node > 0) point.node = node;
    point.at = mesh.length_m * position_of(mesh.geometry, label);
    if (axes) point.axes = *axes;
    point.place = fmt::format("{}: node {}", name, label);
    points.push_back(point);
  }
  return points;
}

void take_directions(const std::filesystem::path& uff, TestGeometry& geometry) {
  const UffFile file = open_uff(uff);
  const UffGeometry own =
      file.bytes.reading([&file] { return read_geometry(file.datasets); });
  for (const auto& [label, unused] : own.nodes) {
    geometry.directions[own_number(label)] = directions_at(own, label);
  }
}

TestGeometry read_geometry_file(const std::filesystem::path& file,
                                double length_m) {
  TestGeometry result =
      is_uff(file) ? geometry_of_uff(file) : geometry_of_table(file, length_m);
  result.file = file;
  if (!result.nodes.empty()) return result;
  throw InputError("it holds no points",
                   file.filename().string(),
                   "export the test's geometry (dataset 2411 or 15), or write "
                   "a table of label, x, y, z");
}

}  // namespace tapfit::acquisition
