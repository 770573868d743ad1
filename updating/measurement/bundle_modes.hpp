// The modes that a test consists of, in place of recordings or FRFs.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "modal/mode_set/mode_set.hpp"

namespace tapfit::updating {

/// Reads the bundle's file of modes. What has no standard deviation, or one of
/// zero, gets the bundle's. Left out, and named among the warnings: modes at
/// 0 Hz and outside the bundle's band. Named there, too: complex shapes.
///
/// @param bundle with a file of modes
/// @throws InputError as of modal::read_modes_file, modal::check_measured; for
///   a point that the test's geometry does not have; where no mode is left
[[nodiscard]] modal::ModeSet read_bundle_modes(
    const acquisition::TestBundle& bundle);

}  // namespace tapfit::updating
