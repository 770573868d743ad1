// The room acquisition/instruments. Files that measuring programs write:
// HDF5 with netCDF4, TDMS, numpy; and what arrays of a file are records of
// time.
// In:  A file.
// Out: Its arrays (acquisition/readers/named_array.hpp), and TimeRecords.
// May include: its row in CONTRIBUTING.md.
//
// Arrays out of HDF5 files, netCDF4 files among them, by way of libhdf5
// (included only here).
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/readers/named_array.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::acquisition {

/// Whether it begins as HDF5 files do.
[[nodiscard]] bool is_hdf5(const std::filesystem::path& file);

/// Datasets "group/name" of numbers (two dimensions at most, besides those of
/// one) and of texts, and attributes "group/name@attribute", those of the file
/// itself by their name alone.
///
/// What lies in other files (external links, storage and virtual datasets) is
/// not followed. The library works in a process of its own (own_process.hpp).
///
/// @throws InputError for a damaged file, for a dataset that memory does not
///   hold; Stopped
[[nodiscard]] std::vector<NamedArray> read_hdf5_arrays(
    const std::filesystem::path& file, const Progress& progress = {});

}  // namespace tapfit::acquisition
