// Meshes with motions and numbers at their points, as ParaView reads them.
//
// Source: "VTK File Formats", The VTK User's Guide, Kitware.
#pragma once

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace tapfit::updating {

/// What a cell is, by its number in VTK.
enum class VtuCellType {
  Vertex = 1,
  Line = 3,
  Triangle = 5,
  Quad = 9,
  Tetra = 10,
  Hexahedron = 12,
  Wedge = 13,
  Pyramid = 14
};

struct VtuCell {
  VtuCellType type = VtuCellType::Vertex;
  std::vector<Eigen::Index> points;  ///< columns of VtuMesh::points
};

struct VtuMesh {
  Eigen::Matrix3Xd points;  ///< [m]
  std::vector<VtuCell> cells;
  /// By name, a column per point: one row of numbers, or three of a vector.
  std::vector<std::pair<std::string, Eigen::MatrixXd>> data;
};

/// A .vtu file, in text.
[[nodiscard]] std::string vtu_text(const VtuMesh& mesh);

/// A .pvd file: the parts of one picture.
/// @param files names beside it
[[nodiscard]] std::string pvd_text(const std::vector<std::string>& files);

}  // namespace tapfit::updating
