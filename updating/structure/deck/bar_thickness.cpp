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

double twist_by_thickness(const BarProperty& property) {
  const double sum = property.I1 + property.I2;
  return sum > 0.0 ? std::min(property.I1, property.I2) / sum : 0.0;
}

}  // namespace tapfit::structure
