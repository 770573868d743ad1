// Bars on a logarithmic axis, one below the other, as an SVG picture.
#pragma once

#include <string>
#include <vector>

namespace tapfit::tui {

struct SvgBar {
  std::string label;
  double value = 0.0;   ///< positive
  std::string written;  ///< beside the bar
  std::string colour;
};

/// @param name what it shows
/// @param axis title of the axis
/// @param factor value to what the axis counts in (100 for per cent)
[[nodiscard]] std::string svg_bars(const std::vector<SvgBar>& bars,
                                   const std::string& name,
                                   const std::string& axis,
                                   double factor);

}  // namespace tapfit::tui
