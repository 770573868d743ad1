// Points, lines and elements of a universal file.
//
//   15    4I10,3E13.5             node, axes, axes, colour, x y z
//   2411  4I10 / 3D25.16          the same on two lines
//   82    3I10 / 80A1 / 8I10      trace line: number, how many, 0 lifts the pen
//   2412  6I10 (/ 3I10) / 8I10    element; beams have an orientation line
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include "acquisition/uff/uff_datasets.hpp"

#include <Eigen/Core>

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace tapfit::acquisition {

struct UffElement {
  int label = 0;
  int kind =
      0;  ///< FE descriptor: 21 beam, 41/91 triangle, 44/94 quadrilateral
  std::vector<int> nodes;
};

/// In the file's own units and axes.
struct UffGeometry {
  std::map<int, Eigen::Vector3d> nodes;
  std::vector<std::vector<int>> trace_lines;  ///< nodes; pieces apart
  std::vector<UffElement> elements;
};

/// Adds what a dataset 15, 2411, 82 or 2412 holds; another one adds nothing.
///
/// @throws InputError with the line for text that is no number and for a
///   dataset that ends within an entry
void add_geometry(const UffDataset& dataset, UffGeometry& geometry);

/// How nodes are written: 2411 has all digits, 15 has six and is what older
/// programs read (those that know no 2411).
enum class UffNodes { D15, D2411 };

/// Writes the nodes and, as one dataset 82, the trace lines, the pen lifted
/// between them. Elements are not written. Nothing is written for no nodes.
void write_geometry(const UffGeometry& geometry,
                    UffNodes as,
                    std::ostream& out);

}  // namespace tapfit::acquisition
