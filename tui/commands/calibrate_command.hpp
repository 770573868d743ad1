// `tapfit calibrate BUNDLE --mass KG`: sensors against the hammer.
#pragma once

#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Gain and delay of every sensor against the hammer, from blows on a body of
/// known mass.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string calibrate_command(const CommandOptions& options,
                                            const Progress& progress);

}  // namespace tapfit::tui
