// What all screens plot, without a terminal.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "tui/document/drawing_text.hpp"
#include "tui/workbench/workbench.hpp"

#include <memory>
#include <vector>

namespace tapfit::tui {

/// As the key P writes them of each screen: "recording.svg", "frf-a.csv". Takes
/// as long as all that the screens need, the diagnosis among it.
/// @throws Stopped
[[nodiscard]] std::vector<PlotFile> all_plots(std::unique_ptr<Workbench> bench,
                                              const Progress& progress);

}  // namespace tapfit::tui
