// Which modes still ring when a block ends, and so in the next hit's.
#pragma once

#include "acquisition/hits/hits.hpp"
#include "modal/mode_set/mode_set.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Poles of which more than a thousandth is left when the block ends [rad/s],
/// also of modes that ring too much for their damping to be resolved.
[[nodiscard]] Eigen::VectorXcd undecayed_poles(const modal::ModeSet& modes,
                                               const acquisition::HitSet& hits);

/// Whether two sets of poles differ by less than matters for what they predict
/// of a decay: a hundredth of the half bandwidth.
[[nodiscard]] bool have_converged(const Eigen::VectorXcd& before,
                                  const Eigen::VectorXcd& after);

}  // namespace tapfit::updating
