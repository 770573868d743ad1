// Ready FRFs, and whether their sensors stayed where they were.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/progress.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <optional>

namespace tapfit::updating {

struct ReadyFrfs {
  signal::FrfSet set;
  std::optional<modal::ModeSet> modes;  ///< default_identification() of the set
};

/// Reads the bundle's file of FRFs and lays out runs and channels. Universal
/// files do not say which sensor was where. Each response point counts as a
/// sensor that stayed there, unless poles of each grid's own explain the FRFs
/// clearly better than common ones: then one sensor was moved, and its mass
/// with it. Which of the two is said among the set's statements.
///
/// @param bundle with a file of FRFs; gets runs and channels
/// @throws InputError as of signal::read_frfs_uff
[[nodiscard]] ReadyFrfs read_ready_frfs(acquisition::TestBundle& bundle,
                                        const Progress& progress);

}  // namespace tapfit::updating
