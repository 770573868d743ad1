// The terminal program: seven screens over one test bundle.
#pragma once

#include "tui/options/app_options.hpp"

#include <filesystem>

namespace tapfit::tui {

/// Opens the bundle and runs until the user quits.
///
/// @param bundle empty: the user picks one in the terminal
/// @return ExitStatus::Done, or StoppedByUser where a signal ended it
/// @throws InputError for a bundle or key script that cannot be read; the
///   terminal is restored before it leaves
int run_app(const std::filesystem::path& bundle, const AppOptions& options);

}  // namespace tapfit::tui
