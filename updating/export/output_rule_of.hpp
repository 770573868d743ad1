// What a test reads, and what may therefore never be written.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/output_rule.hpp"

namespace tapfit::updating {

/// The rule for what is written of a test: its test.json or universal file, its
/// recordings, FRFs, matrices, deck with what that includes, and session.json,
/// which the program keeps by itself, are never written over. Reads the deck's
/// lines.
///
/// @param force whether other files that are there may be replaced
[[nodiscard]] acquisition::OutputRule output_rule_of(
    const acquisition::TestBundle& bundle, bool force);

}  // namespace tapfit::updating
