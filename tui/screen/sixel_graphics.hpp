// Pictures as terminals take them that know sixels: bands of six rows, each ink
// of a band for itself, a character per column. They lie in place of the text.
//
//   ESC P 0 ; 1 ; 0 q " 1 ; 1 ; WIDTH ; HEIGHT  #INK ; 2 ; R ; G ; B ...
//   #INK !COUNT CHARACTER ... $ ... - ... ST      (ST: Esc and a backslash)
//
// Source: Digital Equipment Corporation, "VT330/VT340 Programmer Reference
// Manual", volume 2, chapter 14.
#pragma once

#include "tui/screen/palette.hpp"
#include "tui/screen/pixel_picture.hpp"

#include <string>

namespace tapfit::tui {

/// Shows it with its upper left corner where the cursor is; what is covered by
/// half or more is drawn, all else left as it is there.
[[nodiscard]] std::string sixel_sequence(const PixelPicture& picture,
                                         const Inks& inks);

}  // namespace tapfit::tui
