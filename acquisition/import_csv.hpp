// Makes a test bundle out of CSV files: test.json and one sound file per CSV.
#pragma once

#include "acquisition/csv_table.hpp"
#include "acquisition/test_bundle.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// What a column of the CSV files is.
struct CsvChannel {
  std::string column;   ///< its name in the header, or its number from 1 on
  std::string channel;  ///< the channel's name in the bundle
  Quantity quantity = Quantity::Acceleration;
  std::string unit = "m/s^2";
  /// Given: the column holds volts, and this many make one unit. Empty: the
  /// column holds the unit itself.
  std::optional<double> volts_per_unit = std::nullopt;
  bool flip_sign = false;
  std::optional<double> mass_kg = std::nullopt;
  Dof dof =
      {};  ///< where it was; for the hammer unless the file says otherwise
};

/// One recording.
struct CsvFile {
  std::filesystem::path file;
  std::optional<Dof> hammer;  ///< where this file's blows fell
};

struct ImportCsvOptions {
  std::vector<CsvFile> files;
  CsvChannel hammer;
  std::vector<CsvChannel> sensors;
  /// Sampling rate [Hz]; empty: from time_column, which then holds seconds.
  std::optional<double> sample_rate_hz;
  std::string time_column = "1";
  CsvOptions csv;
  std::string title;
  std::optional<std::filesystem::path> deck;
  std::optional<std::array<double, 2>> band_hz;
  std::filesystem::path folder;  ///< of the new bundle
  bool overwrite = false;        ///< an existing test.json
};

/// Writes the bundle, reads it back (so that it is checked like any other) and
/// returns it. The samples keep every digit: 64-bit WAV, scaled by a power of
/// two that leaves room above the largest value.
///
/// @throws InputError for what read_csv_columns refuses, uneven sampling, a
///   rate that is no whole number of Hz (sound files cannot say it), an
///   unknown unit, a bundle that is there already
TestBundle import_csv(const ImportCsvOptions& options);

}  // namespace tapfit::acquisition
