// Tops of blows at a level that may be a ceiling, and those below it, which say
// what shape blows have.
#pragma once

#include "acquisition/hits/pulse_top.hpp"

#include <vector>

namespace tapfit::acquisition {

inline constexpr double equal_levels = 0.01;  ///< at a ceiling, relative
/// Behind a filter shorter ones have no shape of their own [samples].
inline constexpr double least_width = 5.0;
inline constexpr double flatter = 0.05;   ///< a loss of 1 % of the impulse
inline constexpr double odd_ones = 20.0;  ///< one of so many may be odd

/// Without tops of less than the least width.
struct TopsByLevel {
  std::vector<PulseTop> highest;  ///< from 1 % below the level on
  std::vector<PulseTop> below;
};

/// @param level_n of the ceiling, > 0 [N]
[[nodiscard]] TopsByLevel tops_by_level(const std::vector<PulseTop>& tops,
                                        double level_n);

/// From which flatness on a top is cut off: by 0.05 flatter, a loss of 1 % of
/// the impulse, than all of these but one in 20; 0.05 of none.
[[nodiscard]] double cut_flatness(const std::vector<PulseTop>& below);

/// The highest level of those that have a shape; 0 of none [N].
[[nodiscard]] double highest_level(const std::vector<PulseTop>& tops);

}  // namespace tapfit::acquisition
