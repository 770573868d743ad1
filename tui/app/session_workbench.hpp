// The real workbench: a session over a test bundle.
#pragma once

#include "tui/workbench/workbench.hpp"

#include <filesystem>
#include <memory>

namespace tapfit::tui {

/// What becomes of the work: taken up from session.json and kept there, or, of
/// a tour, neither.
enum class Work { Kept, Forgotten };

/// @throws InputError for a bundle that cannot be read
[[nodiscard]] std::unique_ptr<Workbench> open_session(
    const std::filesystem::path& bundle, Work work = Work::Kept);

}  // namespace tapfit::tui
