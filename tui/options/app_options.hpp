// How the terminal program is shown.
#pragma once

#include "tui/screen/terminal_graphics.hpp"

#include <filesystem>
#include <optional>

namespace tapfit::tui {

struct AppOptions {
  bool ascii = false;      ///< only ASCII glyphs, whatever the locale
  bool no_colour = false;  ///< as if NO_COLOR were set
  bool no_mouse = false;
  bool blocks = false;                   ///< no braille dots
  std::optional<GraphicsWish> graphics;  ///< empty: as the settings say
  bool light = false;   ///< the terminal's background is light ...
  bool dark = false;    ///< ... or dark, whatever COLORFGBG says
  bool tour = false;    ///< with words on what is seen; of no bundle: of the
                        ///< demonstration
  bool inside = false;  ///< read nothing from outside the bundle's folder
  /// A key script (key_script.hpp) replayed without a terminal; the screens
  /// it asks for, or else the last one, go to standard output as text.
  std::optional<std::filesystem::path> keys_file;
  int width = 80;   ///< [columns] of the replayed screen
  int height = 24;  ///< [rows]
};

}  // namespace tapfit::tui
