// A cheap look at every effect at every grid: how much of the present misfit
// would go if it sat there, uncertain properties and damping readjusting.
//
// One degree of freedom b with dynamic stiffness z changes every FRF by
//   delta H_oi = -H_ob w H_bi,   w = z / (1 + H_bb z)      (eq. 15, rank one)
// which is scanned over sizes of z. The readjustment is linear: the misfit is
// projected off the tangent space of the other parameters.
#pragma once

#include "acquisition/progress.hpp"
#include "updating/fitter.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// A hypothesis and what the screening thinks of it.
struct Screened {
  PlacedEffect placed;
  double error = 0.0;  ///< relative FRF error it would leave
};

/// What a unit of flexibility change at each candidate grid does.
struct PlacePatterns {
  std::vector<int> nodes;
  Eigen::VectorXcd s;                     ///< lines used
  std::vector<Eigen::MatrixXcd> pattern;  ///< per node: lines x FRFs, H_ob H_bi
  std::vector<Eigen::MatrixXcd> own;      ///< per node: lines x FRFs, H_bb
};

/// @param nodes grids to look at
/// @param component direction 1..3
[[nodiscard]] PlacePatterns place_patterns(const Fit& current,
                                           const Target& target,
                                           const std::vector<int>& nodes,
                                           int component,
                                           const Progress& progress);

/// Screens the point effects of the catalogue at every grid.
///
/// @return all hypotheses, least remaining error first
[[nodiscard]] std::vector<Screened> screen(const Fit& current,
                                           const Fitter& fitter,
                                           const Progress& progress);

}  // namespace tapfit::updating
