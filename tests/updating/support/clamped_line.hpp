// Many bars in a row, as a deck.
#pragma once

#include "tests/updating/support/deck_support.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace tapfit::structure {

// A clamped line of bars along x, 10 mm x 20 mm of steel.
inline Deck clamped_line(int bars, double bar_m) {
  constexpr double width = 0.01;
  constexpr double height = 0.02;
  std::string text = fmt::format(
      "BEGIN BULK\nPARAM,COUPMASS,1\nMAT1,1,2.1+11,,.3,7850.\n"
      "PBAR,1,1,{},{},{},4.6-9\n",
      width * height,
      width * std::pow(height, 3) / 12.0,
      height * std::pow(width, 3) / 12.0);
  for (int i = 0; i <= bars; ++i) {
    text += fmt::format("GRID,{},,{},0.,0.\n", i + 1, i * bar_m);
  }
  for (int i = 1; i <= bars; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
  }
  return deck_of(text + "SPC1,1,123456,1\nENDDATA\n");
}

}  // namespace tapfit::structure
