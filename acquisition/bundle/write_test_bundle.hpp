// Writes a test bundle's test.json, the counterpart of read_test_bundle.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <filesystem>
#include <string>

namespace tapfit::acquisition {

/// The text of a test.json that is to stand in the folder; paths as below.
[[nodiscard]] std::string test_bundle_text(const TestBundle& bundle,
                                           const std::filesystem::path& folder);

/// Writes FOLDER/test.json (the folder is made when it is not there).
///
/// Recordings, model and FRF files are not copied; their paths are written
/// relative to the folder when they lie in it, else as they are. A path
/// without a folder part is taken to lie in the folder.
///
/// @throws InputError when the folder or file cannot be written
void write_test_bundle(const TestBundle& bundle,
                       const std::filesystem::path& folder);

}  // namespace tapfit::acquisition
