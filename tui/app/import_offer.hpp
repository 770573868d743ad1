// A file of time records as a test of its own: what is assumed of it, shown
// before anything is written.
#pragma once

#include "acquisition/import/propose_import.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::tui {

/// Whether its ending is that of a file of time records, which is no test by
/// itself.
[[nodiscard]] bool is_recording(const std::filesystem::path& file);

struct ImportOffer {
  acquisition::ImportProposal proposal;
};

/// A test in a folder beside the file, called as the file without its ending.
/// @throws InputError for what propose_import() refuses, a folder that holds a
///   test already
[[nodiscard]] ImportOffer offer_import(const std::filesystem::path& file);

/// Channels, what the file says and what is assumed.
[[nodiscard]] std::vector<std::string> lines_of(const ImportOffer& offer);

/// Writes the test.
/// @return its folder
/// @throws InputError as import_recordings()
std::filesystem::path accept(const ImportOffer& offer);

}  // namespace tapfit::tui
