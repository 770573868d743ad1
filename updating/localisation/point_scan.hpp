// What would be left of the misfit without a mistake of the set-up. Of a point
// that was at another grid the FRFs are rows of the same columns: with x_i = H*
// e_i and V the base's rows,
//
//   H_o'i = s^2 V_o' x_i  (a sensor),   H_oi' = s^2 x_o' V_i'  (a blow),
//
// in the direction that the sheet has, for all grids at once. Everything else
// readjusts to first order (misfit_scan.hpp).
#pragma once

#include "updating/fit/fitter.hpp"
#include "updating/localisation/projected_misfit.hpp"
#include "updating/places/location.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace tapfit::updating {

/// A grid at which a point of the sheet may have been.
struct PointElsewhere {
  Location where;      ///< the point, with its node
  double error = 0.0;  ///< relative FRF error it would leave
};

struct PointScanOptions {
  /// Of the misfit's square, what the point's FRFs must have in it to be looked
  /// at: no other grid can take away more.
  double least_share = 0.14;
  std::size_t grids = 3;  ///< the best ones of each point
};

class PointScan {
 public:
  /// @param current its model may be asked about any grid
  /// @param misfit of that fit and target
  /// @param measured the target's FRFs
  PointScan(const Fit& current,
            const Target& target,
            const ProjectedMisfit& misfit,
            const signal::FrfSet& measured);

  /// @param points channels at a grid of the sheet, and runs
  /// @return the best grids of the points that were looked at
  [[nodiscard]] std::vector<PointElsewhere> elsewhere(
      const std::vector<Location>& points,
      const PointScanOptions& options = {});

  /// Relative FRF error that a mistake without parameters would leave, put
  /// right as it is: FRFs of other ends, or times what its channel makes of
  /// them. Only one end of an FRF may be another.
  [[nodiscard]] double error_without(const EffectInstance& mistake) const;

  /// What the FRFs of the place's channels in its runs have in the square of
  /// the misfit.
  [[nodiscard]] double share(const Location& where) const;

 private:
  // An FRF of which one end is elsewhere.
  struct MovedEnd {
    std::size_t frf = 0;
    bool hammer = false;

    auto operator<=>(const MovedEnd&) const = default;
  };
  // What it changes with that end at each grid, as the misfit sees it.
  struct ChangeAtGrids {
    Eigen::VectorXd power;
    Eigen::MatrixXd shared;  // directions x grids
  };

  [[nodiscard]] std::vector<MovedEnd> ends_of(const Location& point) const;
  [[nodiscard]] double share(const std::vector<MovedEnd>& ends) const;
  [[nodiscard]] bool passes(const Location& where, std::size_t frf) const;
  void prepare(const std::vector<MovedEnd>& ends);
  [[nodiscard]] Eigen::VectorXd errors(const std::vector<MovedEnd>& ends) const;
  [[nodiscard]] Eigen::MatrixXd directions(std::size_t frf) const;
  [[nodiscard]] const Dof& end_now(const MovedEnd& end) const;
  [[nodiscard]] const Eigen::MatrixXd& rows_of(const Dof& dof) const;
  [[nodiscard]] Eigen::MatrixXcd column_of(const MovedEnd& end) const;
  [[nodiscard]] ChangeAtGrids change_of(const MovedEnd& end) const;
  [[nodiscard]] Eigen::VectorXd weighed(std::size_t frf,
                                        const Eigen::VectorXcd& lines) const;
  [[nodiscard]] ChangeAtGrids seen(std::size_t frf,
                                   const Eigen::VectorXcd& there) const;
  [[nodiscard]] Eigen::VectorXcd put_right(std::size_t frf,
                                           const PairEnds& real,
                                           const EffectInstance& mistake) const;

  const FrfModel* model_;
  const ModelState* state_;
  const Target* target_;
  const ProjectedMisfit* misfit_;
  const signal::FrfSet* measured_;
  std::array<Eigen::MatrixXd, 6> rows_;  // of the base, each n_grids x r
  std::vector<PairEnds> ends_;
  std::vector<FrfModel::Walk> walks_;
  Eigen::MatrixXcd now_;
  Eigen::VectorXd share_;  // of each FRF in the square of the misfit
  std::map<MovedEnd, ChangeAtGrids> changes_;
};

}  // namespace tapfit::updating
