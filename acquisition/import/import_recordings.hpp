// The room acquisition/import. A test bundle made of tables of samples.
// In:  Files of time records of any kind, and what the user says of their
//      channels.
// Out: A folder with test.json and one sound file per table.
// May include: its row in CONTRIBUTING.md.
//
// Makes a test bundle out of files of samples
// (acquisition/import/read_time_table.hpp): test.json and one sound file for
// each.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/foundation/progress.hpp"
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
  /// Of a column that holds the unit: what the recorder has divided by.
  std::optional<double> recorded_volts_per_unit = std::nullopt;
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
  /// which then holds seconds, or what its header says.
  std::optional<double> sample_rate_hz;
  /// Variable of a file of arrays that holds the rate [Hz].
  std::optional<std::string> rate_variable;
  /// Empty: the first column of a CSV; what the other kinds say.
  std::optional<std::string> time_column;
  CsvOptions csv;
  std::string title;
  std::optional<std::filesystem::path> deck;
  std::optional<std::array<double, 2>> band_hz;
  std::optional<double> block_s;
  std::filesystem::path folder;  ///< of the new bundle
  /// Of the folder: its inputs, and whether other files may be replaced.
  OutputRule rule = {};
};

/// Refuses what can be told before any file is read.
/// @throws InputError for a file that is not there, a bundle that is
void check_import(const ImportOptions& options);

/// What to say of a file that tells no sampling rate.
[[noreturn]] void refuse_without_rate(const std::filesystem::path& file);

/// Writes the bundle, reads it back (so that it is checked like any other) and
/// returns it, with a warning for each column that is zero throughout, each
/// rate that a column of times gave and that was rounded, and times that are no
/// seconds. The
/// samples keep every digit: 64-bit WAV, scaled by a power of two that leaves
/// room above the largest value.
///
/// @throws InputError for a file that is not there, what read_time_table
///   refuses, uneven sampling, a rate that is no whole number of Hz (sound
///   files cannot say it), an unknown unit, a bundle that is there already, a
///   sound file that is without `force`; Stopped. The folder is then as it was
TestBundle import_recordings(const ImportOptions& options,
                             const Progress& progress = {});

}  // namespace tapfit::acquisition
