// What stands over the page or below it: the tour's words, the palette of
// commands, the fit that runs.
#include "tui/app/program.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/update_panels.hpp"
#include "tui/widgets/text_box.hpp"
#include "tui/workbench/tour_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {

Screen Program::tour(const Canvas& canvas) const {
  // A fit shows how it goes on there.
  if (!tour_ || acting()) return {canvas.width, 0};
  const std::vector<std::string> lines =
      wrapped(tour_words(current_, known_), std::min(canvas.width - 8, 72));
  const int rows = static_cast<int>(lines.size()) + 2;
  Screen box(canvas.width, rows, canvas.ascii);
  draw_text_box(box, "tour (:tour ends it)", lines, {.colour = Colour::Sky});
  return box;
}

/// Above the line that is typed: the commands that it may be.
void Program::draw_palette(Screen& screen) const {
  if (mode_ != Mode::Colon) return;
  const std::vector<CommandWords> words = palette(typed_);
  const bool number = typed_.find_first_of("1234567") == 0;
  if (words.empty() && number) return;  // of a screen
  if (words.empty()) {
    const Rect box{0, screen.height() - 3, std::min(screen.width(), 76), 3};
    screen.fill(box, U' ');
    screen.box(box, "command", {.colour = Colour::Sky});
    screen.text(2, box.y + 1, "no command is called so", {}, box.width - 4);
    return;
  }
  const auto most = static_cast<std::size_t>(std::max(screen.height() - 4, 1));
  const bool all = words.size() <= most;
  const std::size_t shown = all ? words.size() : most - 1;
  const int rows = static_cast<int>(std::min(words.size(), most)) + 2;
  const Rect rect{
      0, screen.height() - rows, std::min(screen.width(), 76), rows};
  screen.fill(rect, U' ');
  screen.box(rect, "command (Tab completes)", {.colour = Colour::Sky});
  screen.zone(
      {.rect = rect, .kind = Zone::Kind::Command, .index = words.size()});
  constexpr int usage_width = 26;
  const int right = rect.width - 2;
  const auto line =
      [&](int y, const std::string& usage, std::string_view does) {
        screen.text(2, y, usage, {.bold = true}, usage_width);
        screen.text(2 + usage_width, y, does, {}, right - usage_width - 2);
      };
  for (std::size_t i = 0; i < shown; ++i) {
    const int y = rect.y + 1 + static_cast<int>(i);
    line(y, words[i].name + " " + words[i].takes, words[i].does);
    screen.text_right(
        right, y, keys_of(words[i].name), {.colour = Colour::Grey});
    screen.zone({.rect = {0, y, rect.width, 1},
                 .kind = Zone::Kind::Command,
                 .index = i});
  }
  if (all) return;
  line(rect.y + rows - 2,
       fmt::format("... {} more", words.size() - shown),
       "a letter finds them");
}

std::string Program::keys_of(const std::string& command) const {
  std::string keys;
  for (const auto* bindings : {&bound_, &usual_bindings()}) {
    for (const KeyBinding& binding : *bindings) {
      if (binding.command == command) keys += " " + key_label(binding.key);
    }
  }
  return keys;
}

/// How a fit that was asked for goes on, in the lower right corner.
void Program::draw_live(Screen& screen) const {
  if (!acting() || shown_.errors.size() < 2 || !shown_.live) return;
  const int width =
      std::min(screen.width(), std::max(50, screen.width() * 3 / 4));
  const int height =
      std::min(screen.height(), std::max(13, screen.height() * 2 / 3));
  const Rect rect{
      screen.width() - width, screen.height() - height, width, height};
  screen.fill(rect, U' ');
  screen.box(rect, shown_.title, {.colour = Colour::Sky});
  const auto [fit, line] = split_top(inside(rect), height - 3);
  draw_live_fit(screen, fit, shown_.errors, *shown_.live);
  screen.text(line.x + 1,
              line.y,
              fmt::format("step {}, {} now; S keeps, Esc discards",
                          shown_.errors.size(),
                          percent(shown_.errors.back())),
              {},
              line.width - 1);
}

}  // namespace tapfit::tui
