// How a command that reads its own command line does so.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>

namespace tapfit::tui {

/// Reads the words into what the app was told to. Where there is nothing to be
/// done then, prints the help that was asked for, or says what is wrong.
///
/// @param check of what the app cannot check: throws CLI::ValidationError
/// @return exit status: 0 for help, 2 where the command line is at fault;
///   empty: go on
[[nodiscard]] std::optional<int> answered(
    CLI::App& app,
    int argc,
    const char* const* argv,
    const std::function<void()>& check = {});

}  // namespace tapfit::tui
