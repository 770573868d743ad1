// Identified modes as universal file: dataset 151 (header), 164 (SI units) and
// one dataset 55 or 2414 per mode, complex, three translations (or six
// components when rotations were measured) per grid.
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "modal/mode_set/mode_set.hpp"

#include <filesystem>
#include <string>

namespace tapfit::modal {

/// Which dataset a mode is written as.
enum class ModeDataset { Uff55, Uff2414 };

/// The file's text. Scaled modes have unit modal mass: modal A = 2 j omega_d
/// and modal B = -lambda A; unscaled ones have zeros there.
[[nodiscard]] std::string modes_as_uff(const ModeSet& modes,
                                       const std::string& title,
                                       ModeDataset as = ModeDataset::Uff55);

/// Writes modes_as_uff to a file.
/// @param points with their systems, behind the modes
/// @throws InputError where the rule does not let it, or it cannot be written
void write_modes_uff(const ModeSet& modes,
                     const std::string& title,
                     const std::filesystem::path& path,
                     const acquisition::OutputRule& rule,
                     ModeDataset as = ModeDataset::Uff55,
                     const acquisition::UffGeometry& points = {});

}  // namespace tapfit::modal
