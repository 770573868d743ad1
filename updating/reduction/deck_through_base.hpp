// Another deck with the same grids through the vectors of a base, for a first
// look: it is assembled, and nothing of the large model is solved.
//
//   V' K V q = omega^2 V' M V q
//
// Its modes come out too high by what they have outside the vectors' span
// (Rayleigh, Ritz): nothing where all of a plate is thicker, a percent where
// its stiffness along and across it are exchanged and one is twice the other,
// some tens of percent of the higher ones where it is ten times the other.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/reduction/base_matrices.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct BaseVectors {
  const Eigen::MatrixXd& V;  ///< n x r
  const PointRows& rows;     ///< of V, for the deck's own grids
  /// Degrees of freedom that are measured or hit, ascending.
  const std::vector<int>& points;
  double high_hz = 0.0;  ///< top of the band
};

/// @param deck the mesh that is solved
/// @return in the coordinates of its modes
[[nodiscard]] ReducedBase deck_through_base(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& uncertain,
    const BaseVectors& base);

}  // namespace tapfit::updating
