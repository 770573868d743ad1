// Modes out of a file of any kind: UFF 55 or 2414, CSV, JSON.
#pragma once

#include "modal/mode_set/mode_set.hpp"

#include <filesystem>

namespace tapfit::modal {

/// Reads JSON where the name ends in .json, a universal file where it begins
/// as one, a table where the name ends in .csv, .tsv or .txt.
///
/// @return what was not read stands among the warnings
/// @throws InputError as of read_modes_json, read_modes_csv, read_modes_uff
[[nodiscard]] ModeSet read_modes_file(const std::filesystem::path& file);

/// Refuses what no measured modes can be.
///
/// @param set by frequency
/// @param name the source's name, for messages
/// @throws InputError naming the mode: for a frequency, damping, shape or
///   standard deviation that is not finite, a frequency below 0, a damping
///   ratio below 0 or of 1 and more, two modes of one frequency that no shapes
///   tell apart, a shape that is zero at all points
void check_measured(const ModeSet& set, const std::string& name);

}  // namespace tapfit::modal
