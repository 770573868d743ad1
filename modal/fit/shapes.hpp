// Mode shapes from residues, which are of rank one and reciprocal:
//
//   2 j omega_d R_ab = phi_a phi_b     (unit modal mass)
//
// Each FRF a / b is an edge between two points. The edges fix the shape up to
// its sign as soon as the points are connected and hold one odd cycle: a
// driving point (a = b), or three points each measured against the others.
// Without one, only the two sides (hit points, sensor points) are known, each
// up to a factor; then the larger side is kept and the shape is unscaled.
#pragma once

#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::modal {

/// What the measured FRFs allow to be known of a shape.
struct ShapeGraph {
  std::vector<Dof> dofs;  ///< kept points, sign +1, by node and component
  bool scaled = false;    ///< an odd cycle gives the scale
  std::vector<std::pair<int, int>> edges;  ///< per FRF: response, reference;
                                           ///< index into all points
  std::vector<Dof> points;                 ///< all points
  std::vector<int> kept;  ///< index into points of each of `dofs`
  std::vector<int> side;  ///< per point: 0 or 1 from the root; -1 unreached
};

/// @param warnings what cannot be known is said here
[[nodiscard]] ShapeGraph shape_graph(const WeightedFrfs& curves,
                                     std::vector<std::string>& warnings);

/// Shapes from the residues of a fit.
///
/// Robust against a few FRFs that contradict the others (a channel of wrong
/// polarity): those are weighted down. The largest value is positive. A scaled
/// shape keeps the phase that R = phi phi' / (2 j w_d) gives it; others are
/// turned to be as real as possible, with 1 for the largest value.
///
/// @param residues of receptance, n_frfs x n_modes
/// @param poles n_modes [rad/s]
/// @return n_dofs x n_modes [1/sqrt(kg)] when scaled
[[nodiscard]] Eigen::MatrixXcd mode_shapes(const ShapeGraph& graph,
                                           const Eigen::MatrixXcd& residues,
                                           const Eigen::VectorXcd& poles,
                                           const Eigen::VectorXd& frf_weight);

}  // namespace tapfit::modal
