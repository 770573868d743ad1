// Matrices that Nastran writes by OUTPUT4, as text or binary.
//
// A head (columns, rows, form, type, name, format of the numbers), then per
// column its number, first row and length, and its numbers; sparse columns have
// row 0 and strings with a first row each. Lines of whole numbers tell where
// numbers go, so that their lengths need not be known.
//
// Source: MSC Nastran DMAP Programmer's Guide, OUTPUT4; MSC Nastran
// Utilities Guide, "OUTPUT4 formats".
#pragma once

#include "updating/structure/solve/sparse_matrix.hpp"

#include <filesystem>

namespace tapfit::structure {

/// Whether the file begins with the head of a matrix, text or binary.
[[nodiscard]] bool is_output4(const std::filesystem::path& path);

/// The matrix whose name begins with a letter, or the only one of the file.
/// @param letter 'K' or 'M'
/// @throws InputError with file and, of text, line for anything but a real,
/// square one
[[nodiscard]] SparseMatrix read_output4(const std::filesystem::path& path,
                                        char letter);

}  // namespace tapfit::structure
