#include "tui/app/app.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/app/key_script.hpp"
#include "tui/app/picker.hpp"
#include "tui/app/program.hpp"
#include "tui/app/recent_bundles.hpp"
#include "tui/app/replay.hpp"
#include "tui/app/session_workbench.hpp"
#include "tui/app/settings.hpp"
#include "tui/options/exit_status.hpp"
#include "tui/options/standard_streams.hpp"
#include "tui/screen/glyphs.hpp"
#include "tui/screen/terminal.hpp"
#include "updating/export/outside_files.hpp"

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

/// Keys that wait, all before the next drawing.
/// @return false where there were none
template <class Shown>
bool take_keys(Terminal& terminal, Shown& shown) {
  bool any = false;
  int wait = frame_ms;
  while (const std::optional<Key> key = terminal.read_key(wait)) {
    any = true;
    wait = 0;
    if (*key == Key(U'z', true)) {
      terminal.suspend();
    } else if (*key != keys::resize) {
      shown.press(*key);
    }
    shown.resize(terminal.width(), terminal.height());
  }
  return any;
}

/// Until the user leaves or a signal asks to.
void converse(Terminal& terminal, Program& program) {
  bool changed = true;
  while (!program.quit() && !Terminal::asked_to_end()) {
    changed = program.tick() || changed;
    changed = program.animate() || changed;
    program.draw_in(terminal.pixels());
    if (changed) terminal.show(program.draw());
    if (changed) terminal.name_window(program.window_title());
    changed = take_keys(terminal, program);
  }
}

using Opened = std::unique_ptr<Workbench>;

Opened open_and_remember(const std::filesystem::path& bundle) {
  Opened opened = open_session(bundle);
  remember_bundle(bundle);
  return opened;
}

Work work_of(const AppOptions& options) {
  return options.tour ? Work::Forgotten : Work::Kept;
}

/// The bundle that the user picks, opened; none where the user leaves.
Opened pick(Terminal& terminal, const AppOptions& options, bool ascii) {
  Picker picker(picker_start(), {terminal.width(), terminal.height(), ascii});
  while (!picker.quit() && !Terminal::asked_to_end()) {
    terminal.show(picker.draw());
    while (!take_keys(terminal, picker) && !Terminal::asked_to_end()) {
    }
    const auto picked = picker.take_picked();
    if (!picked) continue;
    try {
      if (options.inside) updating::check_inside(*picked);
      return open_and_remember(*picked);
    } catch (const InputError& error) {
      picker.refuse(error.what());
    }
  }
  return nullptr;
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

/// Who asks for blocks or ASCII is given them.
GraphicsWish wanted_graphics(const AppOptions& options,
                             const Settings& settings,
                             Glyphs glyphs) {
  if (glyphs == Glyphs::Ascii) return GraphicsWish::Off;
  return options.graphics.value_or(options.blocks ? GraphicsWish::Off
                                                  : settings.graphics);
}

std::unique_ptr<Terminal> open_terminal(const AppOptions& options,
                                        const Settings& settings,
                                        Glyphs glyphs) {
  const char* variable = std::getenv("COLORFGBG");
  const std::string said = variable != nullptr ? variable : "";
  const bool light = settings.light.value_or(is_light(said));
  return std::make_unique<Terminal>(
      TerminalOptions{options.no_colour ? Theme::Mono : settings.theme,
                      options.no_mouse,
                      glyphs == Glyphs::Blocks,
                      options.light || (!options.dark && light),
                      wanted_graphics(options, settings, glyphs)});
}

int ended() {
  return Terminal::asked_to_end() ? ExitStatus::StoppedByUser
                                  : ExitStatus::Done;
}

int run_in_terminal(Opened bench,
                    std::unique_ptr<Terminal> terminal,
                    const AppOptions& options,
                    const Settings& settings,
                    bool ascii) {
  Program program(std::move(bench),
                  {terminal->width(), terminal->height(), ascii},
                  settings);
  program.show_tour(options.tour);
  program.copy_with(
      [&terminal](const std::string& text) { terminal->copy(text); });
  converse(*terminal, program);
  terminal.reset();  // the shell's again, whatever is still to be awaited
  const int status = ended();
  if (!let_go(program)) {
    std::fflush(nullptr);
    std::_Exit(status);  // every step was saved when it was done
  }
  return status;
}

int replay_keys(const std::filesystem::path& bundle,
                const AppOptions& options,
                bool ascii) {
  Opened bench = open_session(bundle, work_of(options));
  const std::vector<ScriptStep> steps = read_key_script(*options.keys_file);
  Program program(std::move(bench), {options.width, options.height, ascii});
  program.show_tour(options.tour);
  const std::string text = replay(program, steps);
  print(text);
  return ExitStatus::Done;
}

std::filesystem::path shown_around() {
  if (auto found = picker_start().demonstration) return *std::move(found);
  throw InputError("the demonstration is not installed with this program",
                   "tapfit tour",
                   "name a test: tapfit tour BUNDLE");
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

int run_app(const std::filesystem::path& asked, const AppOptions& options) {
  const bool shows_around = asked.empty() && options.tour;
  const std::filesystem::path bundle = shows_around ? shown_around() : asked;
  const Glyphs glyphs = wanted_glyphs(options);
  const bool ascii = glyphs == Glyphs::Ascii;
  if (options.keys_file) return replay_keys(bundle, options, ascii);
  Opened bench;
  if (options.tour) {
    bench = open_session(bundle, work_of(options));
  } else if (!bundle.empty()) {
    bench = open_and_remember(bundle);
  }
  const Settings settings = read_settings(settings_file());
  std::unique_ptr<Terminal> terminal = open_terminal(options, settings, glyphs);
  if (bundle.empty()) bench = pick(*terminal, options, ascii);
  if (bench == nullptr) return ended();
  return run_in_terminal(
      std::move(bench), std::move(terminal), options, settings, ascii);
}

}  // namespace tapfit::tui
