// Writes down what was done after every action, so that nothing is lost.
#pragma once

#include "tui/work/snapshot.hpp"
#include "tui/work/workbench.hpp"

#include <string>

namespace tapfit::tui {

/// Saves the work; notes in the snapshot whether that failed.
/// @return what was done, and what went wrong behind it
[[nodiscard]] std::string keep_work(Workbench& bench,
                                    Snapshot& known,
                                    const Progress& progress,
                                    const std::string& done);

}  // namespace tapfit::tui
