#include "tui/options/terminal_options.hpp"

namespace tapfit::tui {

void add_terminal_options(CLI::App& app,
                          std::filesystem::path& bundle,
                          AppOptions& options) {
  app.add_option(
      "BUNDLE",
      bundle,
      "Test to open in the terminal: its folder, or a universal file");
  app.add_flag("--ascii", options.ascii, "Only ASCII characters");
  app.add_flag("--blocks", options.blocks, "Blocks instead of braille dots");
  app.add_option_function<std::string>(
         "--graphics",
         [&options](const std::string& word) {
           options.graphics = graphics_wish(word);
         },
         "Pixels for plots: by kitty's protocol, by sixels, or none")
      ->check(CLI::IsMember({"auto", "kitty", "sixel", "off"}));
  app.add_flag(
      "--no-colour,--no-color", options.no_colour, "No colours (as NO_COLOR)");
  app.add_flag("--light", options.light, "Colours for a light background");
  app.add_flag("--dark", options.dark, "Colours for a dark background");
  app.add_flag("--no-mouse", options.no_mouse, "Disable the mouse");
  app.add_option(
         "--keys", options.keys_file, "Replay a key script without a terminal")
      ->type_name("FILE");
  app.add_option("--width", options.width, "Columns of the replay")
      ->capture_default_str();
  app.add_option("--height", options.height, "Rows of the replay")
      ->capture_default_str();
}

}  // namespace tapfit::tui
