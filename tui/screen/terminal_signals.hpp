// What signals do while there are screens: those that end the program ask it
// to, crashes restore the terminal first.
#pragma once

namespace tapfit::tui {

/// The terminal's line modes as they are, for restore_modes() and crashes.
void keep_modes();
void restore_modes();

/// @param pictures kitty's graphics are shown, which would stay
void take_signals(bool pictures);
void give_signals_back();

/// A signal asked the program to end, or ask_to_end() did, since
/// take_signals().
[[nodiscard]] bool end_was_asked();
void ask_to_end();

/// The program was stopped and goes on, since the last call: others may have
/// written on the terminal.
[[nodiscard]] bool was_continued();

}  // namespace tapfit::tui
