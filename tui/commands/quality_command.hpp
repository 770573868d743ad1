// `tapfit quality BUNDLE` and `tapfit calibrate BUNDLE --mass KG`: what the
// measurement says about itself.
#pragma once

#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Coherence of sensors x hits, hits that stand apart, driving points,
/// reciprocity, lowest lines, H1 against H2 at the peaks.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string quality_command(const CommandOptions& options,
                                          const Progress& progress);

/// Gain and delay of every sensor against the hammer, from blows on a body of
/// known mass.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string calibrate_command(const CommandOptions& options,
                                            const Progress& progress);

}  // namespace tapfit::tui
