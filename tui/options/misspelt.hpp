// What was meant by words of a command line that are none.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace tapfit::tui {

/// "Did you mean --json?" and the end of its line, for the first word that
/// could not be used and is near to an option or command. Empty where none is.
[[nodiscard]] std::string meant_words(const CLI::App& app);

/// "Did you mean tapfit diagnose?": for a word in the place of a bundle.
[[nodiscard]] std::string meant_command(const CLI::App& app,
                                        const std::string& word);

/// What the parser says, in plain words: "--band takes 2 values, 1 was given".
[[nodiscard]] std::string plain_words(std::string text);

}  // namespace tapfit::tui
