// What a test reads, and what may therefore never be written.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "updating/structure/cards/bulk_lines.hpp"

#include <filesystem>
#include <vector>

namespace tapfit::updating {

/// All files that a test reads. Reads the deck's lines; what a deck that cannot
/// be read, or may not be opened, would include is not known.
///
/// @param bundle its paths alone count
[[nodiscard]] std::vector<std::filesystem::path> inputs_of(
    const acquisition::TestBundle& bundle,
    const structure::MayOpen& may_open = {});

/// The rule for what is written of a test: its test.json or universal file, its
/// recordings, FRFs, geometry, matrices, deck with what that includes, and
/// session.json, which the program keeps by itself, are never written over; nor
/// is what other tests in its folder and in those of the outputs read
/// (output_rule_of_folder). Reads the decks' lines.
///
/// @param force whether other files that are there may be replaced
/// @param outputs what is to be written
[[nodiscard]] acquisition::OutputRule output_rule_of(
    const acquisition::TestBundle& bundle,
    bool force,
    const std::vector<std::filesystem::path>& outputs = {});

}  // namespace tapfit::updating
