// The missing dynamic stiffness at a place against frequency, with the law
// that fits it best, or all three.
#pragma once

#include "tui/plot.hpp"
#include "tui/plot_range.hpp"
#include "updating/diagnosis.hpp"

namespace tapfit::tui {

[[nodiscard]] Plot signature_plot(const updating::Signature& signature,
                                  const PlotRange& range,
                                  bool all_laws = false);

}  // namespace tapfit::tui
