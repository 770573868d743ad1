// Modes out of a file: what `tapfit modes --json` prints, or a universal file.
#pragma once

#include "modal/mode_set/mode_set.hpp"

#include <filesystem>
#include <string>

namespace tapfit::tui {

/// Reads the modes of a JSON file (name ending in .json) or of a universal
/// file (datasets 55 and 2414).
///
/// @throws InputError for a missing file, one without modes, or a field that
///   is missing or of the wrong kind
[[nodiscard]] modal::ModeSet read_modes_file(const std::filesystem::path& file);

/// As above, from the text of a JSON file.
/// @param name the source's name, for messages
[[nodiscard]] modal::ModeSet read_modes_json(const std::string& text,
                                             const std::string& name);

}  // namespace tapfit::tui
