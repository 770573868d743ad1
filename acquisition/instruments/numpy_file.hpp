// Arrays of numpy's files: the one of a .npy, called after the file, or those
// of a .npz under their keys.
#pragma once

#include "acquisition/readers/named_array.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::acquisition {

/// Whether it begins as a .npy file does.
[[nodiscard]] bool is_npy_file(const std::filesystem::path& file);
/// Whether it begins as a zip archive does.
[[nodiscard]] bool is_npz_file(const std::filesystem::path& file);

/// @throws InputError as read_npy, list_zip and unzip
[[nodiscard]] std::vector<NamedArray> read_npy_arrays(
    const std::filesystem::path& file);
[[nodiscard]] std::vector<NamedArray> read_npz_arrays(
    const std::filesystem::path& file);

}  // namespace tapfit::acquisition
