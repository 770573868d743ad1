// A universal file opened: its bytes mapped and taken apart into datasets.
#pragma once

#include "acquisition/readers/mapped_file.hpp"
#include "acquisition/uff/uff_datasets.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// A universal file taken apart; views point into the mapped bytes.
struct UffFile {
  MappedFile bytes;
  std::string name;
  std::vector<UffDataset> datasets;
};

/// @throws InputError as MappedFile and split_uff. What is read of it later is
///   read within MappedFile::reading()
[[nodiscard]] UffFile open_uff(const std::filesystem::path& file);

/// The dataset of that number.
/// @throws InputError where the file has no such dataset any more: it was
///   written anew since its datasets were counted
[[nodiscard]] const UffDataset& dataset_of(const UffFile& file,
                                           std::size_t number);

/// Whether a file begins as universal files do, with a line of "-1".
[[nodiscard]] bool is_uff(const std::filesystem::path& file);

}  // namespace tapfit::acquisition
