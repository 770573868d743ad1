// What is to be made a bundle, and how.
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
  /// Of a column that holds the unit: what the recorder has divided by.
  std::optional<double> recorded_volts_per_unit = std::nullopt;
  bool flip_sign = false;
  std::optional<double> mass_kg = std::nullopt;
  Dof dof =
      {};  ///< where it was; for the hammer unless the file says otherwise
};

/// One file: a recording, or several runs.
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

}  // namespace tapfit::acquisition
