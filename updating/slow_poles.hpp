// Which modes still ring when a block ends, and so in the next hit's.
#pragma once

#include "acquisition/hits.hpp"
#include "modal/mode_set.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Whether any run has a hit that another one comes before.
[[nodiscard]] bool several_hits(const acquisition::HitSet& hits);

/// Poles of which more than a thousandth is left when the block ends [rad/s].
[[nodiscard]] Eigen::VectorXcd slow_poles(const modal::ModeSet& modes,
                                          const acquisition::HitSet& hits);

}  // namespace tapfit::updating
