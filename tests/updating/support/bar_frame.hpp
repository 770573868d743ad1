// A clamped angle of two thick bars that moves across its plane, as a deck in
// the units asked for. Its card lacks K1 and K2, and its bars bend up to the
// crossing of their lines: of both forms (deck_forms.hpp) it knows nothing.
//
//   1 o--o--o--o--o--o--o--o--o 9     steel, 40 mm wide, 30 mm high (along z),
//                             |       0.4 m along x from the clamp,
//                             o 15    0.3 m along y
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace tapfit::support {

/// A metre and a kilogram in the units of a deck.
struct DeckUnits {
  double metre = 1.0;
  double kilogram = 1.0;
};
inline constexpr DeckUnits mm_t_s{1e3, 1e-3};

inline std::string frame_text(const DeckUnits& units = {}) {
  constexpr int along_x = 8;
  constexpr int along_y = 6;
  constexpr double width = 0.04;
  constexpr double height = 0.03;
  const double m = units.metre;
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int k = 0; k <= along_x + along_y; ++k) {
    text += fmt::format("GRID,{},,{:.12g},{:.12g},0.,,126\n",
                        k + 1,
                        0.05 * m * std::min(k, along_x),
                        0.05 * m * std::max(k - along_x, 0));
  }
  for (int k = 1; k <= along_x + along_y; ++k) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", k, k, k + 1);
  }
  text += fmt::format("PBAR,1,1,{:.12g},{:.12g},{:.12g},{:.12g}\n",
                      width * height * std::pow(m, 2),
                      width * std::pow(height, 3) / 12.0 * std::pow(m, 4),
                      height * std::pow(width, 3) / 12.0 * std::pow(m, 4),
                      1.9e-7 * std::pow(m, 4));
  text += fmt::format("MAT1,1,{:.12g},,.3,{:.12g}\n",
                      2.1e11 * units.kilogram / m,
                      7850.0 * units.kilogram / std::pow(m, 3));
  return text + "SPC1,1,123456,1\nENDDATA\n";
}

}  // namespace tapfit::support
