// Where a sensible engineer would put sensors and hit, for any model.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <vector>

namespace tapfit::updating {

struct TestPoints {
  std::vector<Dof> sensors;  ///< where every mode of the band is well seen
  std::vector<Dof> others;   ///< well spread, the sensors' points among them
};

/// 1..3: the axis along which the model is thinnest; Z where that is no single
/// one.
[[nodiscard]] int test_direction(const structure::Deck& deck);

/// Sensors at the grids at which the weakest mode is strongest, a third of the
/// model's size or more apart; the others by farthest-point sampling.
///
/// @param shapes of the model, n_grids x modes, in the test direction
/// @param count of `others`; at most the number of grids that move
/// @param fixed sensor points that are given; empty: chosen
[[nodiscard]] TestPoints choose_points(const structure::Deck& deck,
                                       const Eigen::MatrixXd& shapes,
                                       int sensors,
                                       int count,
                                       const std::vector<Dof>& fixed = {});

/// Shapes of the model's elastic modes up to a frequency, at all grids in one
/// direction (zero where held); the lowest frequency comes with them.
struct ModelShapes {
  Eigen::VectorXd frequency_hz;
  Eigen::MatrixXd shapes;  ///< n_grids x modes
};
[[nodiscard]] ModelShapes model_shapes(const structure::Deck& deck,
                                       int component,
                                       double max_hz);

}  // namespace tapfit::updating
