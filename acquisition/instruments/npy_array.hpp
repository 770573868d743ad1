// One array of numpy: the content of a .npy file, or of an entry of .npz.
//
//   \x93NUMPY  version (2 bytes)  length of the header (2 or 4 bytes)
//   {'descr': '<f8', 'fortran_order': False, 'shape': (1024, 3), }
//   the values
//
// Source: numpy.lib.format, "NPY format", versions 1.0 to 3.0.
#pragma once

#include "acquisition/readers/named_array.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace tapfit::acquisition {

/// Whether the bytes begin as those of an array do.
[[nodiscard]] bool is_npy(std::string_view bytes);

/// Integers, floats and booleans of either byte order, texts ('U' and 'S');
/// what else there is (complex, records, Python's objects) has no content.
///
/// @param name of the array
/// @param room of the file
/// @throws InputError for bytes that are none, that end early, for what memory
///   does not hold
[[nodiscard]] NamedArray read_npy(std::string_view bytes,
                                  const std::string& name,
                                  const std::filesystem::path& file,
                                  ArrayRoom& room);

}  // namespace tapfit::acquisition
