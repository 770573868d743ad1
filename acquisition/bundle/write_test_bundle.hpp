// A test bundle as test.json, the counterpart of read_test_bundle.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <filesystem>
#include <string>

namespace tapfit::acquisition {

/// The text of a test.json that is to stand in the folder.
///
/// Paths of recordings, model and FRF files are written relative to the folder
/// when they lie in it, else as they are. A path without a folder part is taken
/// to lie in the folder.
[[nodiscard]] std::string test_bundle_text(const TestBundle& bundle,
                                           const std::filesystem::path& folder);

}  // namespace tapfit::acquisition
