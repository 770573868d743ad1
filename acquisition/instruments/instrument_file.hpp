// Files of instruments whose content is arrays with names: MATLAB, HDF5 and
// netCDF4, TDMS, numpy. Their kind is told by how they begin, MATLAB's by .mat.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/instruments/time_record.hpp"
#include "acquisition/readers/named_array.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

struct InstrumentFile {
  std::filesystem::path file;
  std::vector<NamedArray> arrays;
  /// Of these, as array_records.hpp says; of several runs those of the first.
  std::vector<TimeRecord> records;
  /// Of frames that stand end to end, each with one hit [samples]; 0: of none.
  Eigen::Index frame = 0;
  std::string time_column = {};  ///< the column that gave the rate, if one did
  /// Runs behind the first, with its channels in its order (file_runs.hpp).
  std::vector<std::vector<TimeRecord>> later_runs = {};
  std::vector<std::string> run_names = {};  ///< of several runs, of all of them
  std::vector<std::string> left_out = {};   ///< records in no run, and why
  std::string doubt = {};  ///< why one run or several cannot be told
};

/// @param run from 0 on
[[nodiscard]] const std::vector<TimeRecord>& records_of(
    const InstrumentFile& file, std::size_t run);

/// Whether the file is of such a kind.
[[nodiscard]] bool is_instrument_file(const std::filesystem::path& file);

/// @throws InputError as the reader of its kind; for netCDF of version 3;
///   Stopped
[[nodiscard]] InstrumentFile read_instrument_file(
    const std::filesystem::path& file, const Progress& progress = {});

/// A record by its column, its name or its number from 1 on; null for none.
[[nodiscard]] const TimeRecord* find_record(
    const std::vector<TimeRecord>& records, const std::string& column);

/// A record of a run as find_record() finds it, else the samples of any array
/// (named_array.hpp), also by its name within the run's group.
/// @param run from 0 on
/// @throws InputError for what is not there, no number or not finite
[[nodiscard]] TimeRecord take_record(const InstrumentFile& file,
                                     const std::string& column,
                                     std::size_t run = 0);

}  // namespace tapfit::acquisition
