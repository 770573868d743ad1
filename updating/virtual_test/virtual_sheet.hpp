// The sheet of a virtual test: test.json as the person who tests writes it,
// mistakes included.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/virtual_test/virtual_setup.hpp"
#include "updating/virtual_test/virtual_spec.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::updating {

/// File of a run, counted from 1.
[[nodiscard]] std::string recording_name(int run);

/// @param folder of the bundle
[[nodiscard]] acquisition::TestBundle test_sheet(
    const VirtualBundleSpec& spec,
    const VirtualSetup& setup,
    std::vector<acquisition::Channel> channels,
    const std::filesystem::path& folder);

}  // namespace tapfit::updating
