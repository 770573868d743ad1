// The three structures of "Model Updating Using Frequency Response Functions
// Based on Sherman-Morrison Formula", worked through by this program.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "tui/paper/paper_report.hpp"

#include <filesystem>

namespace tapfit::tui {

/// Tables 1 to 4, Figures 5 and 8.
/// @param folder of recordings/paper-truss
[[nodiscard]] PaperReport paper_truss(const std::filesystem::path& folder,
                                      const Progress& progress);

/// Tables 5 and 6.
/// @param folder of recordings/paper-solar-wing
[[nodiscard]] PaperReport paper_wing(const std::filesystem::path& folder,
                                     const Progress& progress);

/// Tables 7 and 8, by diagnosis of a whole recording; takes a minute.
/// @param folder of recordings/solar-panel-frame
[[nodiscard]] PaperReport paper_frame(const std::filesystem::path& folder,
                                      const Progress& progress);

}  // namespace tapfit::tui
