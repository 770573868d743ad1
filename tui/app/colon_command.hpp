// What is typed after ':', and the keys that stand for some of it.
#pragma once

#include "tui/screen/key.hpp"
#include "updating/effects/effect.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tapfit::tui {

struct ColonCommand {
  enum class Kind {
    Quit,
    Help,
    Add,
    Toggle,
    Undo,
    Redo,
    Drop,  ///< this and the next three as of mode_action()
    Pick,
    Pair,
    Band,
    Screen,
    Split,  ///< without a number: opens one, or ends the one there is
    Only,
    Close,
    Run,
    Report,
    Deck,
    Uff,
    Plot,
    Copy,
    Keep,
    Stop,
    Retry,
    Tour
  };
  Kind kind = Kind::Help;
  /// Effect of Add; what follows Drop to Band; file of Report to Plot.
  std::string argument;
  std::size_t number = 0;  ///< of Screen, Split, Run, Toggle; from 1
};

/// "q", "help", "add added-mass@201", "toggle 2", "undo", "redo", "screen 3",
/// "3", "split 4", "only", "close", "run 12", "report", "deck FILE", "uff",
/// "plot", "copy", "keep", "stop", "retry", "drop 12.98", "pick 12.98", "pair
/// 2:3", "band 10 60"; a name may be cut short while it is clear ("sc 3").
///
/// @throws InputError for what is none of these
[[nodiscard]] ColonCommand parse_colon_command(std::string_view text);

/// The text with the name of the one command that may be meant as of palette()
/// ("repot" to "report"): not to be carried out before it was seen. Empty where
/// the text names a command, or none or several may be meant.
[[nodiscard]] std::string guessed(std::string_view text);

/// What is shown of a command while it is typed.
struct CommandWords {
  std::string name;
  std::string takes;  ///< "HZ", "[FILE]"
  std::string does;
  bool takes_more = false;  ///< it can do nothing without
};

/// The commands that the text may be going on to: those that begin so or, where
/// none does, hold its letters in this order or, where none does, are nearly
/// called so or tell of it in what they do.
[[nodiscard]] std::vector<CommandWords> palette(std::string_view text);

/// A key that carries out what could be typed after ':'.
struct KeyBinding {
  Key key;
  std::string command;
  std::string brief;  ///< what the help has beside the key
};

/// Those of keys that do the same on every screen.
[[nodiscard]] const std::vector<KeyBinding>& usual_bindings();

/// The key's, or null.
[[nodiscard]] const KeyBinding* binding_of(
    const std::vector<KeyBinding>& bindings, Key key);

/// What the text may be going on to: commands by their names, after "add " the
/// effects of the catalogue, and after '@' their places. Empty where nothing
/// fits.
///
/// @param context as of place_words()
[[nodiscard]] std::vector<std::string> completions(
    std::string_view text, const effects::TestContext& context);

/// The text and what all of its completions have in common beyond it.
[[nodiscard]] std::string completed(std::string_view text,
                                    const effects::TestContext& context);

}  // namespace tapfit::tui
