#include "tui/widgets/mac_map.hpp"

#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {

int rigid_modes(const Eigen::VectorXd& hz) {
  const double highest = hz.size() > 0 ? hz.maxCoeff() : 0.0;
  // Rounding leaves them a ten thousandth of a structure's own, or less.
  constexpr double at_rest = 1e-3;
  Eigen::Index count = 0;
  while (count < hz.size() && hz[count] <= at_rest * highest) ++count;
  return count < hz.size() ? static_cast<int>(count) : 0;
}

HeatMap mac_map(const Eigen::MatrixXd& mac, const Eigen::VectorXd& hz) {
  HeatMap map;
  map.title = "MAC in %: measured with model";
  map.values = mac;
  map.first = rigid_modes(hz);
  map.left = map.first;
  for (const double one : hz) {
    map.column_names.push_back(fitted(one, map.entry_width - 1));
  }
  return map;
}

std::string rigid_words(const Eigen::VectorXd& hz) {
  const int count = rigid_modes(hz);
  if (count == 0) return {};
  return fmt::format(
      " ({} rigid-body mode{} left out)", count, count == 1 ? "" : "s");
}

bool step_column(std::size_t& column, const Eigen::VectorXd& hz, Key key) {
  const bool back = key == U'h' || key == keys::left;
  if (!back && key != U'l' && key != keys::right) return false;
  const auto first = static_cast<std::size_t>(rigid_modes(hz));
  const auto count = static_cast<std::size_t>(hz.size());
  if (count == 0) return true;
  column = std::clamp(column, first, count - 1);
  if (back && column > first) --column;
  if (!back && column + 1 < count) ++column;
  return true;
}

}  // namespace tapfit::tui
