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
  std::vector<TimeRecord> records;  ///< of these, as array_records.hpp says
  /// Of frames that stand end to end, each with one hit [samples]; 0: of none.
  Eigen::Index frame = 0;
  std::string time_column = {};  ///< the column that gave the rate, if one did
};

/// Whether the file is of such a kind.
[[nodiscard]] bool is_instrument_file(const std::filesystem::path& file);

/// @throws InputError as the reader of its kind; for netCDF of version 3;
///   Stopped
[[nodiscard]] InstrumentFile read_instrument_file(
    const std::filesystem::path& file, const Progress& progress = {});

/// A record by its column, its name or its number from 1 on; null for none.
[[nodiscard]] const TimeRecord* find_record(
    const std::vector<TimeRecord>& records, const std::string& column);

/// A record as find_record() finds it, else the samples of any array
/// (named_array.hpp).
/// @throws InputError for what is not there, no number or not finite
[[nodiscard]] TimeRecord take_record(const InstrumentFile& file,
                                     const std::string& column);

}  // namespace tapfit::acquisition
