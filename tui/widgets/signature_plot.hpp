// The missing dynamic stiffness at a place against frequency, with the law
// that fits it best, or all of them.
#pragma once

#include "tui/widgets/plot.hpp"
#include "tui/widgets/plot_range.hpp"
#include "updating/localisation/signature.hpp"

namespace tapfit::tui {

/// @param resonant draw an absorber's law in place of the best of the others:
///   it has three parameters, and is worth drawing where one is suspected
[[nodiscard]] Plot signature_plot(const updating::Signature& signature,
                                  const PlotRange& range,
                                  bool all_laws = false,
                                  bool resonant = false);

}  // namespace tapfit::tui
