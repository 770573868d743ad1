// What a change at a place would leave of the misfit, for any law of frequency
// at a grid and any size of a loss or a joint, without forming the changed
// FRFs: only their sums over the FRFs of a line are kept,
//
//   power_l  = sum_f |V_lf|^2,      V = s^2 pattern, weighted as the residual
//   shared_l = sum_f conj(B_lf) V_lf,
//
// B the misfit and every direction in which the rest of the model readjusts.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/localisation/projected_misfit.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Places to be scanned, by the rows that feel them (see LocationOperators).
struct ScannedPlaces {
  std::vector<Eigen::MatrixXd> grids;  ///< 1 x r each
  std::vector<Eigen::MatrixXd> parts;  ///< k x r each: elements, joints
  /// Places that are the sum of parts, by position among them.
  std::vector<std::vector<std::size_t>> sums;
};

class LocationScan {
 public:
  /// @param misfit of the same fit and target
  LocationScan(const Fit& current,
               const Target& target,
               const ProjectedMisfit& misfit,
               const ScannedPlaces& places,
               const Progress& progress);

  /// Error left with each of several laws at a grid.
  /// @param z lines x laws, the dynamic stiffness [N/m]
  [[nodiscard]] Eigen::VectorXd errors(std::size_t grid,
                                       const Eigen::MatrixXcd& z) const;

  /// Error left by any law of frequency at a grid: the best multiple of the
  /// pattern at every line by itself, nothing readjusting.
  [[nodiscard]] double any_law(std::size_t grid) const;

  /// The best compliance at a sum of parts, and the error left with it.
  /// @param sign -1: the best stiffness that is added
  [[nodiscard]] ProjectedMisfit::Scaled scaled(std::size_t sum,
                                               double sign = 1.0) const;

 private:
  // Of one grid on the runs that effects act alike on.
  struct LineSums {
    Eigen::VectorXcd own;     // H_bb
    Eigen::VectorXd power;    // per line
    Eigen::MatrixXcd shared;  // directions x lines
  };
  struct Walked;

  void take_grids(const Walked& walked, const ScannedPlaces& places);
  void take_sums(const Walked& walked, const ScannedPlaces& places);

  const ProjectedMisfit* misfit_;
  Eigen::Index lines_ = 0;
  std::vector<std::vector<LineSums>> grids_;  // per grid, per walk
  Eigen::VectorXd power_;                     // per sum
  Eigen::MatrixXd shared_;                    // directions x sums
};

}  // namespace tapfit::updating
