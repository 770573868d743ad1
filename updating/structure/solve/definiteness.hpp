// Whether stiffness and mass are those of a structure: no motion may have
// negative energy.
#pragma once

#include "updating/structure/solve/system.hpp"

namespace tapfit::structure {

/// Whether x' A x < 0 for some x, by more than 1e-9 of what its parts are
/// (1e-14 of the largest diagonal entry where they are small): tested on A
/// scaled to a unit diagonal.
/// @param A symmetric, full storage; may be singular
[[nodiscard]] bool is_indefinite(const SparseMatrix& A);

/// @throws InputError when stiffness or mass over the free motions is
///   indefinite
void refuse_indefinite(const SparseMatrix& K, const SparseMatrix& M);

}  // namespace tapfit::structure
