// Coordinate systems of a universal file, and which way its nodes measure.
//
//   18    5I10 / name / 6E13.5, 3E13.5   number, kind, reference, colour,
//                                        method; origin, a point on +x, one on
//                                        the +xz plane, in the reference
//   2420  I10 / name, then 3I10 / name / 4 (3D25.16)
//                                        label, kind, colour; unit vectors x,
//                                        y, z and the origin, in global axes
//
// Kinds: 0 rectangular, 1 cylindrical, 2 spherical. A node's coordinates count
// in its definition system (15; those of a 2411 are global), its directions, of
// functions and of shapes, along those of its displacement system. System 0 is
// the global one, and so is 1 where the file does not define it.
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "acquisition/uff/uff_geometry.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Adds the systems of a dataset 18 or 2420.
/// @throws InputError with the line for text that is no number, axes that are
///   none, a kind that is not known, a reference that leads nowhere
void add_systems(const UffDataset& dataset, UffGeometry& geometry);

/// A system in global axes.
/// @param user who needs it, for the message
/// @throws InputError where it, or one that it counts in, is not in the file
[[nodiscard]] CoordinateSystem system_of(const UffGeometry& geometry,
                                         int label,
                                         const std::string& user);

/// A node's place in global axes, in the file's unit of length.
/// @throws InputError where its definition system is not in the file
[[nodiscard]] Eigen::Vector3d position_of(const UffGeometry& geometry,
                                          int node);

/// Directions of a node's components, columns in global axes; global ones for a
/// node that the file has no place of.
/// @throws InputError where its displacement system is not in the file
[[nodiscard]] Eigen::Matrix3d directions_at(const UffGeometry& geometry,
                                            int node);

/// The axes of a node that are askew to the global ones, each called by the one
/// that it is closest to; empty where all three are along global ones.
/// @throws InputError as directions_at
[[nodiscard]] std::optional<Eigen::Matrix3d> skew_axes(
    const UffGeometry& geometry, int node);

/// A degree of freedom as the file says it, along global axes, or at a point of
/// the test's own with the node's skew axes. Node 0 stays as it is.
/// @throws InputError as directions_at
[[nodiscard]] Dof turned(const UffGeometry& geometry, const Dof& dof);

/// The geometry and systems of all datasets of a file.
[[nodiscard]] UffGeometry read_geometry(const std::vector<UffDataset>& file);

/// Labels that stand for points of the test's own: beyond any grid's id in a
/// Nastran deck.
[[nodiscard]] int uff_label(int node);
[[nodiscard]] int node_of_uff_label(int label);

}  // namespace tapfit::acquisition
