// Stiffness and mass from any other program: two Matrix Market files and a
// table that says which row is which degree of freedom.
//
// Source: R. F. Boisvert, R. Pozo, K. A. Remington, "The Matrix Market exchange
// formats: initial design", NISTIR 5935, 1996.
#pragma once

#include "updating/structure/system.hpp"

#include <filesystem>

namespace tapfit::structure {

struct MatrixModel {
  Deck deck;      ///< grids only (positions zero where the table has none)
  System system;  ///< six per grid; those that no row stands for are inactive
};

/// Real sparse (coordinate) or dense (array) matrix; symmetric or general.
/// @throws InputError with the file and line for anything else
[[nodiscard]] SparseMatrix read_matrix_market(
    const std::filesystem::path& path);

/// @param dofs CSV, one line per matrix row in order: node, component and
///   optionally x, y, z [m]. The component is 1 to 6 or X, Y, Z, RX, RY, RZ. A
///   first line that does not begin with a number is a heading.
/// @throws InputError for sizes that do not agree, a matrix that is not
///   symmetric, a degree of freedom named twice
[[nodiscard]] MatrixModel read_matrix_system(
    const std::filesystem::path& stiffness,
    const std::filesystem::path& mass,
    const std::filesystem::path& dofs);

}  // namespace tapfit::structure
