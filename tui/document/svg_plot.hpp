// Plots as SVG pictures: the same curves as on the screens, with ticks and a
// legend.
#pragma once

#include "tui/document/svg_canvas.hpp"
#include "tui/widgets/drawing.hpp"

#include <string>

namespace tapfit::tui {

struct Picture {
  double width = 680.0;  ///< [px]
  double height = 320.0;
  bool titled = false;  ///< the plot's title above it; else it has a caption
};

/// A curve of more points than the picture has columns keeps the lowest and the
/// highest of each column. The cursor is left out.
[[nodiscard]] std::string svg_plot(const Plot& plot,
                                   const Picture& picture = {});

/// The same scale both ways, as on the screen; without axes where they have no
/// names.
[[nodiscard]] std::string svg_plane(const PlanePlot& plane,
                                    const Picture& picture = {});

}  // namespace tapfit::tui
