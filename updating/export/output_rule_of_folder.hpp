// What the tests that stand in a folder read, and what may therefore never be
// written there, for commands that make a test.
#pragma once

#include "acquisition/foundation/output_rule.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::updating {

/// The rule for what is written into a folder. A test in it is a file named
/// test.json, or one of any other name that holds a JSON object with "tapfit";
/// it is an input, and so are the files it names and the INCLUDEs of its deck.
/// Tests that cannot be read count, too.
///
/// @param folder need not be there
/// @param force whether other files that are there may be replaced
/// @param made files that the program has made and that were not changed since:
///   no inputs, unless a test that is not among them names them
[[nodiscard]] acquisition::OutputRule output_rule_of_folder(
    const std::filesystem::path& folder,
    bool force,
    const std::vector<std::filesystem::path>& made = {});

}  // namespace tapfit::updating
