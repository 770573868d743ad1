// Recordings whose encoding leaves out what an ear does not miss, and an FRF
// does.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

/// One statement for each such encoding among the runs' sound files, with the
/// first file and what to do. Files that cannot be opened count as none.
[[nodiscard]] std::vector<std::string> lossy_statements(
    const TestBundle& bundle);

}  // namespace tapfit::acquisition
