// A matrix as coloured cells with numbers, as an SVG picture.
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::tui {

struct SvgHeatMap {
  std::string name;        ///< what it shows
  Eigen::MatrixXd values;  ///< what is no finite number is left blank
  double full = 1.0;       ///< the value of the darkest colour
  double factor = 100.0;   ///< on the numbers written
  int decimals = 0;        ///< of the numbers written
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  std::string row_title;
  std::string column_title;
  bool alarming = false;  ///< what is large is bad: orange instead of blue
};

[[nodiscard]] std::string svg_heat_map(const SvgHeatMap& map);

}  // namespace tapfit::tui
