// The samples of all files of an import, run by run, with the rates that sound
// files can say.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/import/import_options.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// One run.
struct ImportTable {
  const ImportFile* source = nullptr;  ///< of the options
  std::size_t run = 0;  ///< from 1 on, of several in its file; 0: the only one
  int rate = 0;
  Eigen::MatrixXd values;          ///< n_rows x (1 + sensors), as in the file
  std::vector<std::string> units;  ///< as the file says, may be empty
  std::vector<std::string> notes;  ///< on times, rate and what is left out
};

/// The hammer and behind it the sensors.
[[nodiscard]] std::vector<ImportChannel> all_channels(
    const ImportOptions& options);

/// What to say of a file that tells no sampling rate.
[[noreturn]] void refuse_without_rate(const std::filesystem::path& file);

/// All runs of all files, in their order.
/// @throws InputError as import_recordings(); Stopped
[[nodiscard]] std::vector<ImportTable> read_import_tables(
    const ImportOptions& options, const Progress& progress = {});

}  // namespace tapfit::acquisition
