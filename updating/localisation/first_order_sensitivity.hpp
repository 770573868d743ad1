// What a unit of change at a place does to every FRF, to first order.
//
//   pattern_oi = sum_k (G H e_o)_k (G H e_i)_k
//
// with G the place's rows (see LocationOperators): a grid's displacement for a
// point effect, strains for a loss of stiffness, moments for a joint.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/fitter.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct FirstOrderSensitivity {
  Eigen::VectorXcd s;
  std::vector<Eigen::MatrixXcd> pattern;  ///< per place: lines x FRFs
  /// Per place of a single row: lines x FRFs, H_bb; empty for wider places.
  std::vector<Eigen::MatrixXcd> own;
};

/// @param rows k x r of each place
[[nodiscard]] FirstOrderSensitivity first_order_sensitivity(
    const Fit& current,
    const Target& target,
    const std::vector<Eigen::MatrixXd>& rows,
    const Progress& progress);

}  // namespace tapfit::updating
