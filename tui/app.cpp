#include "tui/app.hpp"

#include "tui/key_script.hpp"
#include "tui/program.hpp"
#include "tui/replay.hpp"
#include "tui/session_workbench.hpp"
#include "tui/terminal.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

void run_in_terminal(std::unique_ptr<Workbench> bench,
                     const AppOptions& options,
                     bool ascii) {
  Terminal terminal({options.no_colour, options.no_mouse});
  Program program(std::move(bench),
                  {terminal.width(), terminal.height(), ascii});
  bool changed = true;
  constexpr int frame_ms = 40;
  while (!program.quit() && !Terminal::asked_to_end()) {
    changed = program.tick() || changed;
    changed = program.animate() || changed;
    if (changed) terminal.show(program.draw());
    changed = false;
    // All keys that wait are taken before the next drawing.
    int wait = frame_ms;
    while (const std::optional<Key> key = terminal.read_key(wait)) {
      if (*key == keys::resize) {
        program.resize(terminal.width(), terminal.height());
      }
      program.press(*key);
      changed = true;
      wait = 0;
    }
  }
}

}  // namespace

int run_app(const std::filesystem::path& bundle, const AppOptions& options) {
  const bool ascii = options.ascii || !locale_is_utf8();
  std::unique_ptr<Workbench> bench = open_session(bundle);
  if (!options.keys_file) {
    run_in_terminal(std::move(bench), options, ascii);
    return 0;
  }
  const std::vector<ScriptStep> steps = read_key_script(*options.keys_file);
  Program program(std::move(bench), {options.width, options.height, ascii});
  const std::string text = replay(program, steps);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

}  // namespace tapfit::tui
