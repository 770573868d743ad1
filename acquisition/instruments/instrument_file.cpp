#include "acquisition/instruments/instrument_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/instruments/file_runs.hpp"
#include "acquisition/instruments/hdf5_file.hpp"
#include "acquisition/instruments/known_layouts.hpp"
#include "acquisition/instruments/numpy_file.hpp"
#include "acquisition/instruments/sampling.hpp"
#include "acquisition/instruments/tdms_file.hpp"
#include "acquisition/readers/mat_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>

namespace tapfit::acquisition {
namespace {

using Arrays = std::vector<NamedArray>;

bool is_mat(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending == ".mat";
}

// Older netCDF, which is no HDF5.
bool is_old_netcdf(const std::filesystem::path& file) {
  std::string bytes(4, '\0');
  std::ifstream in = open_input(file);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return in && bytes.starts_with("CDF") && bytes[3] >= 1 && bytes[3] <= 5;
}

Arrays refuse_old_netcdf(const std::filesystem::path& file, const Progress&) {
  throw InputError("is netCDF of version 3, which is not read",
                   file.string(),
                   "make it version 4 with nccopy -k nc4 OLD.nc NEW.nc");
}

using ReadArrays = Arrays (*)(const std::filesystem::path&, const Progress&);

// Of kinds that are read at once.
template <Arrays (*read)(const std::filesystem::path&)>
Arrays at_once(const std::filesystem::path& file, const Progress&) {
  return read(file);
}

// Null for other kinds.
ReadArrays reader_of(const std::filesystem::path& file) {
  if (is_mat(file)) return &read_mat_arrays;
  if (is_hdf5(file)) return &read_hdf5_arrays;
  if (is_tdms(file)) return &at_once<read_tdms_arrays>;
  if (is_npz_file(file)) return &at_once<read_npz_arrays>;
  if (is_npy_file(file)) return &at_once<read_npy_arrays>;
  if (is_old_netcdf(file)) return &refuse_old_netcdf;
  return nullptr;
}

void check_finite(const TimeRecord& record, const std::filesystem::path& file) {
  for (Eigen::Index i = 0; i < record.values.size(); ++i) {
    if (std::isfinite(record.values[i])) continue;
    throw InputError(
        fmt::format(
            "\"{}\" is no finite number at sample {}", record.name, i + 1),
        file.string(),
        "cut the record there");
  }
}

// "run2/time" for "time", where there is one.
std::string name_in_run(const InstrumentFile& file,
                        const std::string& column,
                        std::size_t run) {
  if (run >= file.run_names.size()) return column;
  for (const char separator : {'/', '.'}) {
    std::string name = file.run_names[run] + separator + column;
    if (find_array(file.arrays, name) != nullptr) return name;
  }
  return column;
}

}  // namespace

bool is_instrument_file(const std::filesystem::path& file) {
  return reader_of(file) != nullptr;
}

InstrumentFile read_instrument_file(const std::filesystem::path& file,
                                    const Progress& progress) {
  progress("reading", 0.0);
  InstrumentFile result{file, reader_of(file)(file, progress), {}, 0, {}};
  progress("reading", 0.5);
  FileRuns read = runs_of_arrays(result.arrays);
  result.records = std::move(read.runs[0].records);
  for (std::size_t k = 0; k < read.runs.size() && read.runs.size() > 1; ++k) {
    result.run_names.push_back(std::move(read.runs[k].name));
    if (k > 0) result.later_runs.push_back(std::move(read.runs[k].records));
  }
  result.left_out = std::move(read.left_out);
  result.doubt = std::move(read.doubt);
  result.frame = rattlesnake_frame(result.arrays);
  return result;
}

const TimeRecord* find_record(const std::vector<TimeRecord>& records,
                              const std::string& column) {
  for (const auto& key : {&TimeRecord::column, &TimeRecord::name}) {
    const auto found = std::ranges::find(records, column, key);
    if (found != records.end()) return &*found;
  }
  for (std::size_t k = 0; k < records.size(); ++k) {
    if (column == std::to_string(k + 1)) return &records[k];
  }
  return nullptr;
}

const std::vector<TimeRecord>& records_of(const InstrumentFile& file,
                                          std::size_t run) {
  return run == 0 ? file.records : file.later_runs.at(run - 1);
}

TimeRecord take_record(const InstrumentFile& file,
                       const std::string& column,
                       std::size_t run) {
  if (const TimeRecord* found = find_record(records_of(file, run), column)) {
    check_finite(*found, file.file);
    return *found;
  }
  TimeRecord record;
  record.name = column;
  record.column = name_in_run(file, column, run);
  record.values = samples_of(file.arrays, record.column, file.file);
  const auto sampling =
      sampling_of(file.arrays, record.column, record.values.size());
  if (sampling) {
    record.rate_hz = sampling->hz;
    record.rate_spread = sampling->spread;
  }
  return record;
}

}  // namespace tapfit::acquisition
