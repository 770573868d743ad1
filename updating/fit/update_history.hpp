// How a fit came about, step by step, for plotting and for saying why it
// stopped.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct UpdateStep {
  double error = 0.0;   ///< after the step, on the lines it was taken on
  double length = 0.0;  ///< largest change of a parameter, relative
  /// Regularisation, Tikhonov's: what the prior of update() amounts to, or that
  /// chosen by plain_update().
  double lambda = 0.0;
  Eigen::VectorXd theta;  ///< after the step, as pack() orders them
  int stage = 0;          ///< 0: widest lines; each fit starts from the last
};

}  // namespace tapfit::updating
