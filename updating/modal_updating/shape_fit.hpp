// Measured shapes as multiples of a model's, with the scatter that the model
// adds to the measurement's own, in proportion to a shape's size:
//
//   min over a_k and e >= 0 of  sum_k sum_i [ r_ik^2 + ln(1 + v_k / sd_ik^2) ],
//   r_ik = (u_ik - a_k phi_ik) / sqrt(sd_ik^2 + v_k),   v_k = e^2 mean_i u_ik^2
//
// The largest likelihood of normal errors with variance sd^2 + v. One e for all
// shapes: with one for each, a fit may buy a perfect shape with all others.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

struct ShapeFit {
  Eigen::VectorXd factor;  ///< a, one per shape
  Eigen::VectorXd excess;  ///< sqrt(v) per shape, in the units of u
  Eigen::MatrixXd r;       ///< m x k [-]
  double misfit = 0.0;     ///< the minimum
};

/// @param u measured, m points x k shapes, real, none of them zero throughout
/// @param phi the model's at the same points; where one is zero so is its a
/// @param sd m x k standard deviations in the units of u, above 0
[[nodiscard]] ShapeFit fit_shapes(const Eigen::MatrixXd& u,
                                  const Eigen::MatrixXd& phi,
                                  const Eigen::MatrixXd& sd);

}  // namespace tapfit::updating
