#include "acquisition/hits/saturated_tops.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace tapfit::acquisition {
TopsByLevel tops_by_level(const std::vector<PulseTop>& tops, double level_n) {
  TopsByLevel parted;
  for (const PulseTop& top : tops) {
    if (top.width < least_width) continue;
    const bool high = top.level >= (1.0 - equal_levels) * level_n;
    (high ? parted.highest : parted.below).push_back(top);
  }
  return parted;
}

double cut_flatness(const std::vector<PulseTop>& below) {
  std::vector<double> all;
  for (const PulseTop& top : below) all.push_back(top.flatness);
  if (all.empty()) return flatter;
  std::ranges::sort(all, std::greater<>());
  const double odd = static_cast<double>(all.size()) / odd_ones;
  return all[static_cast<std::size_t>(odd)] + flatter;
}

double highest_level(const std::vector<PulseTop>& tops) {
  double level = 0.0;
  for (const PulseTop& top : tops) {
    if (top.width >= least_width) level = std::max(level, top.level);
  }
  return level;
}

}  // namespace tapfit::acquisition
