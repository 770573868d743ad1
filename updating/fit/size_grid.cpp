#include "updating/fit/size_grid.hpp"

#include <cmath>
#include <utility>

namespace tapfit::updating {

std::vector<std::vector<double>> size_grid(
    const std::vector<effects::ParameterSpec>& specs,
    const std::vector<int>& counts) {
  std::vector<std::vector<double>> result = {{}};
  for (std::size_t k = 0; k < specs.size(); ++k) {
    const double low = std::log(specs[k].lower);
    const double high = std::log(specs[k].upper);
    const int count = counts.at(k);
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& start : result) {
      for (int n = 0; n < count; ++n) {
        longer.push_back(start);
        longer.back().push_back(
            std::exp(low + (high - low) * (n + 0.5) / count));
      }
    }
    result = std::move(longer);
  }
  return result;
}

std::vector<std::vector<double>> size_grid(
    const std::vector<effects::ParameterSpec>& specs) {
  if (specs.size() == 1) return size_grid(specs, {13});
  if (specs.size() == 2) return size_grid(specs, {8, 4});
  return size_grid(specs, {7, 24, 3});
}

}  // namespace tapfit::updating
