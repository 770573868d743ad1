// The section of a shell, of one material or several layers of it.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/elements/section_matrices.hpp"

namespace tapfit::structure {

/// @throws InputError when a material has no stiffness
[[nodiscard]] ShellSection shell_section(const Deck& deck, const Shell& shell);

}  // namespace tapfit::structure
