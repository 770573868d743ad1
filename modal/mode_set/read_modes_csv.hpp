// Modes out of a table: a header line, then a line for each mode.
//
//   frequency_hz, frequency_sd_hz, damping_percent, 12Z+, 12Z+ sd, 14Z+ re,
//   14Z+ im
//
// Columns by name, in any order; only frequency_hz has to be there:
//   frequency_hz; frequency_sd_hz or frequency_sd_percent
//   damping_ratio or damping_percent; damping_sd or damping_sd_percent
//   a point such as 12Z+ for a real shape, or its two parts 12Z+ re, 12Z+ im
//   12Z+ sd: standard deviation of the value there
// Other columns (names of modes) are left out and noted.
#pragma once

#include "modal/mode_set/mode_set.hpp"

#include <filesystem>

namespace tapfit::modal {

/// @return not scaled; by frequency
/// @throws InputError with file:line:column for a cell that is no finite
///   number, for a table without frequencies, without modes, with half of a
///   complex shape, or with two columns that say the same (12Z+ and 12Z-)
[[nodiscard]] ModeSet read_modes_csv(const std::filesystem::path& file);

}  // namespace tapfit::modal
