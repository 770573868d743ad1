// How a structure hangs that its model leaves free. A spring k to ground where
// its rigid-body modes phi_r (of unit modal mass) move by b' phi_r makes one of
// them a mode of its own at
//
//   omega^2 = k sum_r (b' phi_r)^2          (the structure being rigid)
//
// sqrt(k / m) at the centre of mass. A test that is called free has these well
// below the first elastic mode, by 5 to 10 times: D. J. Ewins, Modal Testing,
// 2nd ed., section 3.2. So k has an upper bound.
#pragma once

#include "updating/effects/effect.hpp"

#include <Eigen/Core>

namespace tapfit::effects {

struct Suspension {
  double highest_hz = 0.0;  ///< of the rigid-body modes on it
  /// The model's rigid-body modes, of unit modal mass: 6 n_grids x count.
  Eigen::MatrixXd rigid;
};

/// The stiffest spring to ground there that leaves the rigid-body modes as low
/// as they are [N/m]; infinite where none of them moves it.
[[nodiscard]] double stiffest_spring(const Suspension& suspension,
                                     const InterfaceDof& at,
                                     const structure::Deck& deck);

}  // namespace tapfit::effects
