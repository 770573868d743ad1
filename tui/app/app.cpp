#include "tui/app/app.hpp"

#include "tui/app/key_script.hpp"
#include "tui/app/program.hpp"
#include "tui/app/replay.hpp"
#include "tui/app/session_workbench.hpp"
#include "tui/options/exit_status.hpp"
#include "tui/options/standard_streams.hpp"
#include "tui/screen/glyphs.hpp"
#include "tui/screen/terminal.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

constexpr int frame_ms = 40;

/// Until the user leaves or a signal asks to.
void converse(Terminal& terminal, Program& program) {
  bool changed = true;
  while (!program.quit() && !Terminal::asked_to_end()) {
    changed = program.tick() || changed;
    changed = program.animate() || changed;
    if (changed) terminal.show(program.draw());
    changed = false;
    // All keys that wait are taken before the next drawing.
    int wait = frame_ms;
    while (const std::optional<Key> key = terminal.read_key(wait)) {
      changed = true;
      wait = 0;
      if (*key == Key(U'z', true)) {
        terminal.suspend();
      } else if (*key != keys::resize) {
        program.press(*key);
      }
      program.resize(terminal.width(), terminal.height());
    }
  }
}

/// What runs still is asked to stop; some of it (a factorisation) does not look
/// for seconds, and nobody should wait for what is thrown away.
/// @return false when it did not stop
bool let_go(Program& program) {
  using namespace std::chrono_literals;
  program.leave();
  for (int i = 0; i < 100 && program.busy(); ++i) {
    std::this_thread::sleep_for(5ms);
  }
  return !program.busy();
}

int run_in_terminal(std::unique_ptr<Workbench> bench,
                    const AppOptions& options,
                    Glyphs glyphs) {
  const char* variable = std::getenv("COLORFGBG");
  const std::string said = variable != nullptr ? variable : "";
  auto terminal = std::make_unique<Terminal>(
      TerminalOptions{options.no_colour,
                      options.no_mouse,
                      glyphs == Glyphs::Blocks,
                      options.light || (!options.dark && is_light(said))});
  Program program(
      std::move(bench),
      {terminal->width(), terminal->height(), glyphs == Glyphs::Ascii});
  program.copy_with(
      [&terminal](const std::string& text) { terminal->copy(text); });
  converse(*terminal, program);
  terminal.reset();  // the shell's again, whatever is still to be awaited
  const int status =
      Terminal::asked_to_end() ? ExitStatus::StoppedByUser : ExitStatus::Done;
  if (!let_go(program)) {
    std::fflush(nullptr);
    std::_Exit(status);  // every step was saved when it was done
  }
  return status;
}

Glyphs wanted_glyphs(const AppOptions& options) {
  const bool utf8 = locale_is_utf8();
  if (options.ascii || !utf8) return Glyphs::Ascii;
  if (options.blocks) return Glyphs::Blocks;
  if (options.keys_file) return Glyphs::Braille;
  const char* terminal = std::getenv("TERM");
  return glyphs_of(terminal != nullptr ? terminal : "", utf8);
}

}  // namespace

int run_app(const std::filesystem::path& bundle, const AppOptions& options) {
  const Glyphs glyphs = wanted_glyphs(options);
  const bool ascii = glyphs == Glyphs::Ascii;
  std::unique_ptr<Workbench> bench = open_session(bundle);
  if (!options.keys_file) {
    return run_in_terminal(std::move(bench), options, glyphs);
  }
  const std::vector<ScriptStep> steps = read_key_script(*options.keys_file);
  Program program(std::move(bench), {options.width, options.height, ascii});
  const std::string text = replay(program, steps);
  print(text);
  return 0;
}

}  // namespace tapfit::tui
