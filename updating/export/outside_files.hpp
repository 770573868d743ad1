// What a test reads from outside its folder. Its paths may lead anywhere, which
// is fine for one's own tests and not for a bundle that comes from a stranger.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::updating {

/// Each once, links followed; reads the deck's lines for what it includes.
[[nodiscard]] std::vector<std::filesystem::path> outside_files(
    const acquisition::TestBundle& bundle);

/// Opens nothing that lies outside.
///
/// @param input a bundle, or a deck by itself
/// @throws InputError naming what lies outside the folder of the bundle or
///   deck; and as read_bundle_paths
void check_inside(const std::filesystem::path& input);

}  // namespace tapfit::updating
