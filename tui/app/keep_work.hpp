// Writes down what was done after every action, so that nothing is lost: not of
// this window, and not of another that has the same test open.
#pragma once

#include "tui/workbench/snapshot.hpp"
#include "tui/workbench/workbench.hpp"
#include "tui/workbench/worker.hpp"

#include <functional>
#include <string>

namespace tapfit::tui {

/// A change of what is saved; returns what was done, in words.
using Change =
    std::function<std::string(Workbench&, Snapshot&, const Progress&)>;

/// A job that changes the test as the last of all windows left it, and saves.
/// Where another one saves meanwhile, it is done anew on top of that. What went
/// wrong stands behind what was done.
[[nodiscard]] Job kept(const std::string& title, Change change);

}  // namespace tapfit::tui
