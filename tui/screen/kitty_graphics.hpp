// Pictures as terminals take them that know kitty's graphics protocol. They lie
// beneath the text and stay until they are taken away.
//
//   ESC _ G KEY=VALUE,... ; DATA ST        (ST: Esc and a backslash)
//
// Source: Kovid Goyal, "Terminal graphics protocol",
// sw.kovidgoyal.net/kitty/graphics-protocol.
#pragma once

#include "tui/screen/palette.hpp"
#include "tui/screen/pixel_picture.hpp"

#include <string>

namespace tapfit::tui {

/// Shows it with its upper left corner where the cursor is, which stays there.
/// @param id above 0, of no other picture that is shown
[[nodiscard]] std::string kitty_sequence(const PixelPicture& picture,
                                         const Inks& inks,
                                         unsigned id);

/// Takes the picture of that id away and forgets its pixels.
[[nodiscard]] std::string kitty_removal(unsigned id);

/// The same of all.
inline constexpr const char kitty_removal_of_all[] = "\033_Ga=d,d=A,q=2\033\\";

}  // namespace tapfit::tui
