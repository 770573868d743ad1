// Columns of samples out of a file of any kind that `tapfit import` takes.
//
//   CSV              columns by name or number
//   MATLAB, HDF5,    channels by name or number, else arrays: "acc", "data:2"
//   TDMS, numpy      (second column), "run.force" (field of a structure),
//                    "run/force" (dataset of a group)
//   SEP-005 .json    a list of {"data": [...], "name": "acc1", "unit_str": "g",
//                    "fs": 2048} (or "time": [...] for fs)
//   universal file   time records by number, 1 for the first
#pragma once

#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/import/time_table.hpp"
#include "acquisition/instruments/instrument_file.hpp"
#include "acquisition/readers/csv_table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Whether the name ends as that of a SEP-005 file does.
[[nodiscard]] bool is_sep005(const std::filesystem::path& file);

/// Time records of a universal file, in its order.
[[nodiscard]] std::vector<const UffDataset*> uff_time_records(
    const UffFile& file);

/// Whether files of this kind say how they were sampled (SEP-005, universal
/// file).
[[nodiscard]] bool says_rate(const std::filesystem::path& file);

/// Which runs of a file columns name, from 0 on: all by a channel's name or
/// number, one alone by the whole name of an array ("run2/acc").
/// @throws InputError for arrays of different runs
[[nodiscard]] std::vector<std::size_t> runs_named(
    const InstrumentFile& file, const std::vector<std::string>& columns);

/// Channels of one run of a file that was read already.
/// @throws InputError for what is not there, no number, or of differing length
///   or rate
[[nodiscard]] TimeTable table_of(const InstrumentFile& file,
                                 const std::vector<std::string>& columns,
                                 std::size_t run = 0);

/// Millivolts are made volts; milliseconds and the like seconds, which is
/// noted.
///
/// @param columns what to read, in the kind's own way of naming it
/// @throws InputError for what is not there, no number, or of differing length;
///   Stopped
[[nodiscard]] TimeTable read_time_table(const std::filesystem::path& file,
                                        const std::vector<std::string>& columns,
                                        const CsvOptions& options,
                                        const Progress& progress = {});

}  // namespace tapfit::acquisition
