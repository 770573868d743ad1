// Reads a test bundle from its folder.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <filesystem>

namespace tapfit::acquisition {

/// Reads and checks FOLDER/test.json (a path to the file itself is accepted).
/// A universal file is a bundle by itself (acquisition/bundle/uff_bundle.hpp).
///
/// @throws InputError with the field's place for a missing or wrong field, an
///   unknown unit, a missing file but for recordings, a channel of no name
[[nodiscard]] TestBundle read_test_bundle(const std::filesystem::path& folder);

}  // namespace tapfit::acquisition
