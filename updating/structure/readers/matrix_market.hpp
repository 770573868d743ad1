// Stiffness and mass from any other program: two files, Matrix Market or
// OUTPUT4, and a table that says which row is which degree of freedom.
//
// Source: R. F. Boisvert, R. Pozo, K. A. Remington, "The Matrix Market exchange
// formats: initial design", NISTIR 5935, 1996.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/sparse_matrix.hpp"

#include <filesystem>

namespace tapfit::structure {

/// Numbered as in System; rows and columns that the table does not name are
/// zero.
struct GivenMatrices {
  SparseMatrix K;
  SparseMatrix M;
};

/// Real sparse (coordinate) or dense (array) matrix; symmetric or general.
/// @throws InputError with the file and line for anything else
[[nodiscard]] SparseMatrix read_matrix_market(
    const std::filesystem::path& path);

/// @param dofs CSV, one line per matrix row in order: node, component and
///   optionally x, y, z [m], of which the last may be left out, on all of a
///   node's lines or any. The component is 1 to 6 or X, Y, Z, RX, RY, RZ. A
///   first line that does not begin with a number is a heading.
/// @return grids (positions zero where the table has none) and matrices, the
///   table as the deck's path;
///   material 1 stands for all of them, its E and rho are 1
/// @throws InputError for sizes that do not agree, a matrix that is not
///   symmetric, a degree of freedom named twice, a node in two places
[[nodiscard]] Deck read_matrix_model(const std::filesystem::path& stiffness,
                                     const std::filesystem::path& mass,
                                     const std::filesystem::path& dofs);

}  // namespace tapfit::structure
