// The sensors' masses from the poles of several set-ups: those at which the
// frequencies freed of them agree best. See
// modal/mass_loading/explain_shifts.hpp.
#pragma once

#include "modal/mass_loading/shift_table.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::modal {

struct MassFit {
  Eigen::VectorXd kg;
  Eigen::MatrixXd covariance;  ///< [kg^2]
  Eigen::Index dof = 0;
  /// Share of the squared shifts; of their upper quartiles, so that a pole
  /// that is wrong does not count.
  double explained = 0.0;
  double p_same_fraction = 1.0;  ///< of c_k beside the masses, by chance
  double same_fraction = 0.0;    ///< rms of c_k when it is fitted
};

/// @param mass_of which mass each sensor has, numbered from 0
/// @param common whether c_k is fitted along
/// @return empty when the masses are not determined or the iteration fails
[[nodiscard]] std::optional<MassFit> mass_from_shifts(
    const ShiftData& data,
    const ShiftTable& table,
    const std::vector<Eigen::Index>& mass_of,
    bool common);

}  // namespace tapfit::modal
