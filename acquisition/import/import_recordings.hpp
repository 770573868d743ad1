// The room acquisition/import. A test bundle made of tables of samples.
// In:  CSV, MATLAB, SEP-005 or universal files, and what the user says of their
//      columns.
// Out: A folder with test.json and one sound file per table.
// May include: its row in CONTRIBUTING.md.
//
// Makes a test bundle out of files of samples
// (acquisition/import/read_time_table.hpp): test.json and one sound file for
// each.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/import/time_table.hpp"
#include "acquisition/readers/csv_table.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// What a column of the files is.
struct ImportChannel {
  std::string column;   ///< as time_table.hpp names them
  std::string channel;  ///< the channel's name in the bundle
  Quantity quantity = Quantity::Acceleration;
  /// Empty: what the file says, else N or m/s^2.
  std::string unit = {};
  /// Given: the column holds volts, and this many make one unit. Empty: the
  /// column holds the unit itself.
  std::optional<double> volts_per_unit = std::nullopt;
  bool flip_sign = false;
  std::optional<double> mass_kg = std::nullopt;
  Dof dof =
      {};  ///< where it was; for the hammer unless the file says otherwise
};

/// One recording.
struct ImportFile {
  std::filesystem::path file;
  std::optional<Dof> hammer;  ///< where this file's blows fell
};

struct ImportOptions {
  std::vector<ImportFile> files;
  ImportChannel hammer;
  std::vector<ImportChannel> sensors;
  /// Sampling rate [Hz]; empty: what the file says, else from time_column,
  /// which then holds seconds.
  std::optional<double> sample_rate_hz;
  /// Variable of a .mat file that holds the rate [Hz].
  std::optional<std::string> rate_variable;
  std::string time_column = "1";
  CsvOptions csv;
  std::string title;
  std::optional<std::filesystem::path> deck;
  std::optional<std::array<double, 2>> band_hz;
  std::filesystem::path folder;  ///< of the new bundle
  /// Of the folder: its inputs, and whether other files may be replaced.
  OutputRule rule = {};
};

/// Writes the bundle, reads it back (so that it is checked like any other) and
/// returns it, with a warning for each column that is zero throughout and each
/// rate that a column of times gave and that was rounded. The
/// samples keep every digit: 64-bit WAV, scaled by a power of two that leaves
/// room above the largest value.
///
/// @throws InputError for a file that is not there, what read_time_table
///   refuses, uneven sampling, a rate that is no whole number of Hz (sound
///   files cannot say it), an unknown unit, a bundle that is there already, a
///   sound file that is without `force`. The folder is then as it was
TestBundle import_recordings(const ImportOptions& options);

}  // namespace tapfit::acquisition
