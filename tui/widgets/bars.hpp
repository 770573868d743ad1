// Horizontal bars for shares and errors, and how an error stands to its floor.
#pragma once

#include "tui/screen/screen.hpp"

#include <string>

namespace tapfit::tui {

/// An error counts as at its floor up to so many times it.
inline constexpr double near_floor = 1.3;

/// A bar of `width` cells, in eighths of a cell; '#' in ASCII.
///
/// @param share 0..1, clamped; what is not finite counts as 0
[[nodiscard]] std::string bar(double share, int width, bool ascii);

/// How many times the floor the error is: "1.2", "11", "320".
[[nodiscard]] std::string times_floor(double error, double floor);

/// "within the floor", "1.2 times the floor, as good as the data allow", "11
/// times the floor"; "without a floor to compare with" where there is none.
[[nodiscard]] std::string against_floor(double error, double floor);

/// The error as a bar along 0..scale with a mark at the floor; green near it.
void draw_error_bar(
    Screen& screen, const Rect& line, double error, double floor, double scale);

}  // namespace tapfit::tui
