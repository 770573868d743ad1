// Mode shapes and the error map for ParaView: the model's mesh with its modes,
// and the measured points with theirs and with the error there.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "updating/comparison/comparison.hpp"
#include "updating/export/vtu_file.hpp"
#include "updating/session/session.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::updating {

/// The grids with shells, solids, bars and rods; "grid" holds their ids, "model
/// 2.08 Hz" a mode's motion.
[[nodiscard]] VtuMesh model_mesh(const structure::Deck& deck,
                                 const ModelModes& modes);

/// The measured points; "error" holds the relative error of their FRFs, "model
/// 2.08 Hz" the motion measured that is paired with that mode, scaled to it, so
/// that both are warped alike. A mode without a partner is "measured 2.08 Hz".
[[nodiscard]] VtuMesh points_mesh(const structure::Deck& deck,
                                  const modal::ModeSet& modes,
                                  const Comparison& comparison);

/// NAME.pvd for NAME-model.vtu and NAME-points.vtu beside it.
[[nodiscard]] std::vector<std::filesystem::path> vtu_files(
    const std::filesystem::path& named);

/// Writes all of these, or none.
/// @param rule what may be replaced
/// @throws InputError for a bundle without a model, a file that cannot be
///   written; Stopped
void write_shapes_vtu(Session& session,
                      const std::filesystem::path& named,
                      const acquisition::OutputRule& rule,
                      const Progress& progress);

}  // namespace tapfit::updating
