// What a screen plots as text: a table of its numbers, and an SVG picture.
#pragma once

#include "tui/widgets/drawing.hpp"

#include <string>
#include <vector>

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

/// A file of a drawing, below the name that all of a screen share.
struct PlotFile {
  std::string ending;  ///< behind the common name: "-a.svg"
  std::string content;
};

/// A picture of each and a table of those with numbers; of several drawings
/// with a letter each, from top to bottom.
[[nodiscard]] std::vector<PlotFile> plot_files(
    const std::vector<Drawing>& drawings);

}  // namespace tapfit::tui
