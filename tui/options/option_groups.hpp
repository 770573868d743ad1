// Options that commands share or that come many at once, each group in the
// file of its name.
#pragma once

#include "tui/options/command.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace tapfit::tui {

/// What `tapfit export` can be told to write, besides FRFs and modes.
void add_export_options(CLI::App& command, CommandOptions& options);
/// @throws CLI::RequiredError where no file is named to write
void check_has_export(const CommandOptions& options);

/// fit_options.cpp: --effect, as often as is wanted.
void add_effects(CLI::App& command, CommandOptions& options);
/// What is wrong with an effect as written; empty where nothing is.
[[nodiscard]] std::string effect_fault(const std::string& text);
/// --lines and --lambda.
void add_regularisation(CLI::App& command, CommandOptions& options);

/// What `tapfit predict` can be told of changes and of the model.
void add_predict_options(CLI::App& command, CommandOptions& options);

/// together_options.cpp: the tests, and what they share.
void add_together_options(CLI::App& command, CommandOptions& options);

/// frf_options.cpp: --estimator, --form, --window, --sigma and --best-hits.
void add_estimate(CLI::App& command, FrfArguments& frf);
/// --free, as often as is wanted.
void add_free_masses(CLI::App& command, CommandOptions& options);

void add_import_options(CLI::App& command, CommandOptions& options);

/// What `tapfit modes` can be told about the identification.
void add_modes_options(CLI::App& command, ModesArguments& arguments);

}  // namespace tapfit::tui
