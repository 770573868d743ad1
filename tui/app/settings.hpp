// What the user has chosen for all tests, in a file: colours, axes, keys.
//
//   {"theme": "high-contrast", "background": "light", "graphics": "off",
//    "magnitude": "dB", "frequency": "logarithmic", "keys": {"F": "plot",
//    "<C-b>": "band 10 60"}}
#pragma once

#include "tui/app/colon_command.hpp"
#include "tui/screen/palette.hpp"
#include "tui/screen/terminal_graphics.hpp"
#include "tui/views/frf_curves.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

struct Settings {
  std::optional<std::filesystem::path> file;  ///< that was read
  Theme theme = Theme::Default;
  std::optional<bool> light;  ///< the background; empty: not said
  GraphicsWish graphics = GraphicsWish::Auto;
  MagnitudeScale magnitude = MagnitudeScale::Logarithmic;
  bool log_frequency = false;
  std::vector<KeyBinding> keys;
  std::vector<std::string> faults;  ///< of what was left as it is without
};

/// $XDG_CONFIG_HOME/tapfit/config.json or ~/.config/tapfit/config.json, whether
/// it is there or not; empty where neither folder is known.
[[nodiscard]] std::optional<std::filesystem::path> settings_file();

/// What the file says. What it says wrongly is a fault each, and left out; so
/// is all of a file that cannot be read. Without a file all is as usual.
[[nodiscard]] Settings read_settings(
    const std::optional<std::filesystem::path>& file);

/// All faults, with the file they are in; empty where there are none.
[[nodiscard]] std::string fault_words(const Settings& settings);

}  // namespace tapfit::tui
