// What a screen plots as text: a table of its numbers, and an SVG picture.
#pragma once

#include "tui/widgets/drawing.hpp"

#include <string>

namespace tapfit::tui {

/// Curves as columns under their names and units, the lines of each within the
/// stretch that is drawn; curves on the same lines share a column for these.
/// A matrix has its names above and on the left. Empty where no numbers are
/// drawn: a picture of the structure.
/// @param separator as of csv_row()
[[nodiscard]] std::string drawing_table(const Drawing& drawing,
                                        char separator = ',');

/// With its title above it.
[[nodiscard]] std::string drawing_picture(const Drawing& drawing);

}  // namespace tapfit::tui
