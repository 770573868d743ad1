// What was measured, as universal files.
#pragma once

#include "acquisition/bundle/uff_records.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"
#include "updating/session/session.hpp"

#include <filesystem>

namespace tapfit::updating {

/// FRFs (dataset 58) and modes (dataset 55) in one universal file.
/// @param nodes dataset of the model's grids
/// @throws InputError where the rule does not let it, or it cannot be written;
///   Stopped
void write_measured_uff(Session& session,
                        const std::filesystem::path& path,
                        const acquisition::OutputRule& rule,
                        acquisition::UffNodes nodes,
                        const Progress& progress);

/// The recordings (dataset 58, or 58b).
/// @throws InputError for ready FRFs, which have none, where the rule does not
///   let it, or it cannot be written; Stopped
void write_recorded_uff(Session& session,
                        const std::filesystem::path& path,
                        const acquisition::OutputRule& rule,
                        acquisition::UffEncoding encoding,
                        acquisition::UffNodes nodes,
                        const Progress& progress);

}  // namespace tapfit::updating
