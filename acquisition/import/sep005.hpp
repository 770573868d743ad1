// Time records as JSON in the keys of SEP-005: a list of objects with "data",
// "name", "unit_str" and "fs" (or "time").
//
// Source: SEP-005 of the sdypy project, "time signals".
#pragma once

#include "acquisition/import/time_table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Names of all signals in their order; empty where one has none.
/// @throws InputError for a file that is no list of signals
[[nodiscard]] std::vector<std::string> sep005_names(
    const std::filesystem::path& file);

/// @param columns names of signals, or their numbers from 1 on
/// @throws InputError with the entry's place for missing keys, what is no
///   number, records of differing length or rate
[[nodiscard]] TimeTable read_sep005(const std::filesystem::path& file,
                                    const std::vector<std::string>& columns);

}  // namespace tapfit::acquisition
