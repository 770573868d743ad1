// What an engineer's mesh may be off by, as factors that are fitted along with
// what is uncertain:
//
//   K(f) = K + sum_k (f_k - 1) K_k,   M(f) = M + sum_k (f_k - 1) M_k
//
// The first scales all that changed when the mesh was split (mesh_shift()): 1
// is the split mesh; where the error falls with the square of the element, 4/3
// is the limit of ever finer ones (Richardson's extrapolation). The second,
// where shells have free edges, is one more than the share of the edges' layer
// that the mesh lacks (edge_twist()).
#pragma once

#include "updating/reduction/mesh_shift.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::updating {

struct MeshFactor {
  Eigen::MatrixXd K;  ///< r x r, in the base's coordinates
  Eigen::MatrixXd M;
  /// By which it acts on vectors outside the base, dofs square; 0 x 0: not.
  structure::SparseMatrix beyond;
};

/// One or two.
/// @param deck the split one
/// @param V dofs x r, the modes of `finer` first
[[nodiscard]] std::vector<MeshFactor> mesh_factors(const structure::Deck& deck,
                                                   const Eigen::MatrixXd& V,
                                                   const MeshModes& finer,
                                                   const MeshModes& coarser);

/// "mesh size", "mesh edges".
[[nodiscard]] std::string mesh_factor_name(std::size_t factor);

/// What is known of ln f of each before anything is measured, around 0: the
/// standard deviation.
[[nodiscard]] std::vector<double> mesh_factor_sd(std::size_t factors);

}  // namespace tapfit::updating
