// Errors that say what led to them.
#pragma once

#include "acquisition/foundation/input_error.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// The error with the first notes at the end of its remedy; unchanged without
/// notes.
[[nodiscard]] InputError with_notes(const InputError& error,
                                    const std::vector<std::string>& notes);

}  // namespace tapfit::structure
