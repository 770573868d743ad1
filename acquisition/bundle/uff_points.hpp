// Points of a universal file that are the test's own, and a universal file as
// the geometry of a test.
#pragma once

#include "acquisition/bundle/test_geometry.hpp"
#include "acquisition/bundle/test_point.hpp"
#include "acquisition/uff/uff_geometry.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Its points in global axes, the systems, and the unit of its coordinates.
struct UffMesh {
  UffGeometry geometry;
  double length_m = 1.0;  ///< by dataset 164; SI without one
};

[[nodiscard]] UffMesh read_uff_mesh(const std::vector<UffDataset>& file);

/// Points whose axes are askew to the global ones: at the grid of their label;
/// at coordinates where the label is one that tapfit gives (uff_label).
/// @param name of the file, for messages
/// @throws InputError for a node in a system that the file does not have
[[nodiscard]] std::vector<TestPoint> own_points(const UffMesh& mesh,
                                                const std::string& name);

/// What X, Y, Z mean at nodes that a universal file of FRFs has itself, in
/// place of what another file of geometry says.
/// @throws InputError for a node in a system that the file does not have
void take_directions(const std::filesystem::path& uff, TestGeometry& geometry);

/// A test's geometry: a universal file (15 or 2411, 18 or 2420), or a table
/// with the columns label, x, y, z.
/// @param length_m unit of a table's coordinates
/// @throws InputError for a file without points, a label that is none, or as
///   its reader
[[nodiscard]] TestGeometry read_geometry_file(const std::filesystem::path& file,
                                              double length_m);

}  // namespace tapfit::acquisition
