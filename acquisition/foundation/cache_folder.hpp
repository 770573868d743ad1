// Where the program keeps what it would else work out anew.
#pragma once

#include <filesystem>
#include <optional>

namespace tapfit::acquisition {

/// $XDG_CACHE_HOME/tapfit or ~/.cache/tapfit, whether it is there or not. Empty
/// where TAPFIT_NO_CACHE is set (to anything but nothing and 0), or neither
/// folder is known.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder();

}  // namespace tapfit::acquisition
