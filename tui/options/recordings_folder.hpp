// Where the demonstration and the paper's structures are, which come with the
// program.
#pragma once

#include <filesystem>

namespace tapfit::tui {

/// The folder of these bundles, beside the program as it is built or as it is
/// installed: relative to the working directory where it lies below that.
/// "recordings" where it is at neither place.
[[nodiscard]] std::filesystem::path recordings_folder();

}  // namespace tapfit::tui
