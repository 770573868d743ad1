// Columns of samples out of a file of any kind that `tapfit import` takes.
//
//   CSV              columns by name or number
//   MATLAB .mat      variables by name: "acc", "data:2" (second column),
//                    "run.force" (field of a structure)
//   SEP-005 .json    a list of {"data": [...], "name": "acc1", "unit_str": "g",
//                    "fs": 2048} (or "time": [...] for fs)
//   universal file   time records by number, 1 for the first
#pragma once

#include "acquisition/import/time_table.hpp"
#include "acquisition/readers/csv_table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Whether the file itself says how it was sampled (SEP-005, universal file).
[[nodiscard]] bool says_rate(const std::filesystem::path& file);

/// @param columns what to read, in the kind's own way of naming it
/// @throws InputError for what is not there, no number, or of differing length
[[nodiscard]] TimeTable read_time_table(const std::filesystem::path& file,
                                        const std::vector<std::string>& columns,
                                        const CsvOptions& options);

}  // namespace tapfit::acquisition
