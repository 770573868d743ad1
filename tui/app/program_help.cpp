// The help on the screen that is shown: what it shows, and every key.
#include "tui/app/program.hpp"
#include "tui/screen/text.hpp"
#include "tui/widgets/text_box.hpp"

#include <algorithm>

namespace tapfit::tui {
namespace {

/// Keys and what they do, in columns as wide as the longest but few.
std::vector<std::string> key_lines(const std::vector<KeyHelp>& keys,
                                   int width) {
  const int columns = std::max(width / 24, 1);
  const int room = width / columns;
  std::vector<std::string> lines;
  int used = width;
  for (const KeyHelp& key : keys) {
    std::string entry = key.key + " ";
    entry.append(static_cast<std::size_t>(std::max(7 - text_width(entry), 0)),
                 ' ');
    entry += key.what;
    const int cells = (text_width(entry) / room + 1) * room;
    if (used + text_width(entry) > width) {
      lines.emplace_back();
      used = 0;
    }
    lines.back() += entry;
    used += cells;
    const int gap = std::min(used, width) - text_width(lines.back());
    lines.back().append(static_cast<std::size_t>(std::max(gap, 0)), ' ');
  }
  return lines;
}

/// With no empty lines where they would take the place of others.
std::vector<std::string> fitted_lines(std::vector<std::string> lines,
                                      int rows) {
  if (static_cast<int>(lines.size()) > rows) {
    std::erase_if(lines, [](const std::string& line) { return line.empty(); });
  }
  return lines;
}

/// Lines to go down by, where the key scrolls.
std::optional<int> scroll_of(Key key, int rows) {
  if (key == U'j' || key == keys::down || key == keys::wheel_down) return 1;
  if (key == U'k' || key == keys::up || key == keys::wheel_up) return -1;
  if (key == keys::page_down) return rows - 1;
  if (key == keys::page_up) return 1 - rows;
  return std::nullopt;
}

}  // namespace

std::vector<std::string> Program::help_lines() const {
  const int width = std::min(canvas_.width - 8, 72);
  std::vector<std::string> lines = wrapped(page().help(), width);
  lines.emplace_back();
  std::vector<KeyHelp> all = page_keys();
  std::vector<KeyHelp> everywhere{
      {"1 … 7", "screens"}, {":", "commands"}, {"Esc", "back, stop work"}};
  for (const KeyBinding& usual : usual_bindings()) {
    if (usual.brief.empty()) continue;
    everywhere.push_back({key_label(usual.key), usual.brief});
  }
  everywhere.push_back({"^Z", "shell, fg back"});
  if (split_) everywhere.push_back({"^W", "w: other screen"});
  if (page().list() != nullptr) everywhere.push_back({"/", "filter the list"});
  for (const KeyHelp& key : everywhere) {
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const KeyHelp& k) {
          return k.key == key.key || k.what == key.what;
        });
    if (!known) all.push_back(key);
  }
  for (const std::string& line : key_lines(all, width)) lines.push_back(line);
  return fitted_lines(std::move(lines), text_box_rows(room().height));
}

Screen Program::help(const Canvas& canvas) const {
  Screen screen(canvas);
  const std::vector<std::string> lines = help_lines();
  const bool all =
      static_cast<int>(lines.size()) <= text_box_rows(canvas.height);
  draw_text_box(screen,
                page().title() + (all ? " (any key closes)"
                                      : " (j k scroll, any other key closes)"),
                lines,
                {.colour = Colour::Sky},
                help_row_);
  return screen;
}

void Program::open_help() {
  help_open_ = true;
  help_row_ = 0;
}

bool Program::scroll_help(Key key) {
  const int rows = text_box_rows(room().height);
  const int last = static_cast<int>(help_lines().size()) - rows;
  const std::optional<int> down = scroll_of(key, rows);
  if (!help_open_ || !down || last <= 0) return false;
  help_row_ = std::clamp(help_row_ + *down, 0, last);
  return true;
}

}  // namespace tapfit::tui
