// The channels of a test by name.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

/// In the order of TestBundle::channels.
[[nodiscard]] std::vector<std::string> channel_names(const TestBundle& bundle);

}  // namespace tapfit::acquisition
