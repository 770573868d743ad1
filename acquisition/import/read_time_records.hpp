// All channels of a file of any kind that `tapfit import` takes, with what the
// file says of them.
#pragma once

#include "acquisition/instruments/instrument_file.hpp"
#include "acquisition/readers/csv_table.hpp"

#include <filesystem>

namespace tapfit::acquisition {

/// The channels; of a CSV the columns of numbers. A column of times is none of
/// them and gives their rate. Names are different from each other.
///
/// @return without arrays where the file is no instrument's
/// @throws InputError as read_time_table; for a file without channels; Stopped
[[nodiscard]] InstrumentFile read_time_records(
    const std::filesystem::path& file,
    const CsvOptions& options,
    const Progress& progress = {});

}  // namespace tapfit::acquisition
