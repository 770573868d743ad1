// The ready FRFs that a bundle names, at the points that the bundle means.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "signal/files/uff58.hpp"

namespace tapfit::updating {

/// As read_frfs_uff; of a test with a geometry of its own at that one's points,
/// along its axes where the FRFs' file has no place of a node.
/// @throws InputError besides for a point that the geometry does not have
[[nodiscard]] signal::UffFrfs read_bundle_frfs(
    const acquisition::TestBundle& bundle);

}  // namespace tapfit::updating
