#include "updating/structure/deck/bar_thickness.hpp"

#include <algorithm>

namespace tapfit::structure {

std::array<bool, 2> bends_across(const BarProperty& property) {
  constexpr double alike = 1.2;
  const double I1 = property.I1;
  const double I2 = property.I2;
  if (std::max(I1, I2) <= alike * std::min(I1, I2)) return {true, true};
  return {I1 < I2, I2 < I1};
}

}  // namespace tapfit::structure
