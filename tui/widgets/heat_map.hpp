// A matrix as coloured numbers: MAC, or error per FRF and band.
#pragma once

#include "tui/screen/screen.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::tui {

struct HeatMap {
  Eigen::MatrixXd values;
  std::vector<std::string> row_names;
  std::vector<std::string> column_names;
  double scale = 1.0;  ///< the value that is shown hottest
  double cold = 0.0;   ///< and the one up to which there is no heat
  int top = 0;         ///< first row shown
  int left = 0;        ///< first column shown
  int first = 0;       ///< columns before it are not for show
  int selected = -1;   ///< row to mark
  int column = -1;     ///< entry of that row to mark
  /// The other way round: 1 is cold, 1 - scale hottest (coherence, MAC of
  /// pairs); entries then have three decimals where there is room for them.
  bool shortfall = false;
  int entry_width = 5;  ///< cells per entry, 4 at least
};

/// How many columns fit into the rectangle.
[[nodiscard]] int fitting_columns(const Rect& rect, const HeatMap& map);

/// Moves what is shown so that the marked entry is among it.
void scroll_to_mark(HeatMap& map, const Rect& rect);

/// 0 for nothing to 6 for `scale` and beyond; 0 for what is not finite.
[[nodiscard]] int heat_of(double value, double scale);

/// Names on the left and above; cut to the rectangle, with an arrow above where
/// columns are left out.
void draw_heat_map(Screen& screen, const Rect& rect, const HeatMap& map);

}  // namespace tapfit::tui
