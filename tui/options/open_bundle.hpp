// Opens the bundle of a command and says on standard error what was odd in its
// input, whatever the command prints of it.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::tui {

/// @throws InputError
[[nodiscard]] updating::Session open_bundle(
    const std::filesystem::path& bundle);

/// The same for a command, before whose work it is seen to that all that it is
/// to write may be written.
[[nodiscard]] updating::Session open_bundle(const CommandOptions& options);

/// @throws InputError where the test consists of modes and has no FRFs
void refuse_modes(const acquisition::TestBundle& bundle);

/// The rule for all that the command writes.
[[nodiscard]] acquisition::OutputRule output_rule(
    const acquisition::TestBundle& bundle, const CommandOptions& options);

/// @throws InputError where a file that the command names, or one that belongs
///   to it, may not be written: an input of the test, or one that is there and
///   `force` is not given
void check_outputs(const acquisition::TestBundle& bundle,
                   const CommandOptions& options);

/// What was odd in the bundle and, where it names one, in the deck.
[[nodiscard]] std::vector<std::string> input_warnings(
    updating::Session& session);

/// The diagnosis with them among its warnings, for results that are read by
/// programs.
[[nodiscard]] updating::Diagnosis with_input_warnings(
    updating::Diagnosis diagnosis, updating::Session& session);

}  // namespace tapfit::tui
