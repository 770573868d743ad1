// How the program draws itself: tabs above, the page, a line for messages and
// progress, the key bar below.
#include "tui/app/program.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/widgets/bars.hpp"
#include "tui/widgets/text_box.hpp"
#include "tui/workbench/next_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

/// @param beside the one that is shown, without the keys
std::string tab_text(std::size_t index, const Page& page, bool beside) {
  return beside ? fmt::format("[{} {}]", index + 1, page.title())
                : fmt::format(" {} {} ", index + 1, page.title());
}

Screen too_small(const Canvas& canvas) {
  Screen screen(canvas);
  const std::vector<std::string> lines =
      wrapped(fmt::format("tapfit needs {} x {} cells, this is {} x {}. "
                          "Enlarge the window, or q to quit.",
                          least_width,
                          least_height,
                          canvas.width,
                          canvas.height),
              std::max(canvas.width, 1));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    screen.text(0, static_cast<int>(i), lines[i]);
  }
  return screen;
}

int key_width(const KeyHelp& key) {
  return text_width(key.key) + 1 + text_width(key.what) + 2;
}

/// A click on "j k" means the first of them, on "^R" Ctrl-R.
void zone_of_key(Screen& screen, const Rect& rect, const std::string& name) {
  const bool ctrl = name.size() == 2 && name[0] == '^';
  const std::optional<NamedKey> key =
      ctrl ? std::nullopt : read_key(fmt::format("<{}>", name));
  Zone zone{.rect = rect, .kind = Zone::Kind::Key};
  if (ctrl) {
    zone.index = static_cast<std::size_t>(name[1] - 'A' + 'a');
    zone.column = 1;
  } else if (key) {
    zone.index = key->key.code;
  } else {
    zone.index = decode(name).front().base;
  }
  screen.zone(zone);
}

/// One key and what it does; the cell after it.
int draw_key(Screen& screen, int x, int y, const KeyHelp& key) {
  const int start = x;
  x = screen.text(x, y, key.key, {.bold = true, .reverse = true}) + 1;
  x = screen.text(x, y, key.what, {.reverse = true});
  zone_of_key(screen, {start, y, x - start, 1}, key.key);
  return x + 2;
}

std::string work_text(const WorkerStatus& status) {
  std::string text = status.title;
  if (status.stage.starts_with(status.title)) return status.stage;
  if (!status.stage.empty()) {
    text += ": " + status.stage;
  }
  return text;
}

std::string seconds_text(double seconds) {
  const auto whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  return fmt::format("{} min {} s", whole / 60, whole % 60);
}

/// Of how long it takes, once that is worth telling; the fullest words first.
std::vector<std::string> time_texts(const WorkerStatus& status) {
  const auto now = std::chrono::steady_clock::now();
  const double spent_s =
      std::chrono::duration<double>(now - status.since).count();
  if (spent_s < 3.0) return {""};
  const std::string spent = ", " + seconds_text(spent_s) + " elapsed";
  const auto left_s = part_left_s(status, now);
  if (!left_s || *left_s < 1.0) return {spent};
  const std::string left = ", about " + seconds_text(*left_s) + " left";
  if (!status.in_parts) return {spent + left, spent};
  return {spent + left + " of this step", spent + left, spent};
}

/// A long name is cut, how far it is and for how long are not.
std::string progress_text(const WorkerStatus& status, int room) {
  const int percents = static_cast<int>(std::lround(100 * status.fraction));
  const std::string what = work_text(status);
  std::string far;
  for (const std::string& time : time_texts(status)) {
    far = fmt::format("{} %{}", percents, time);
    std::string whole = fmt::format("{} … {}", what, far);
    if (text_width(whole) <= room) return whole;
  }
  return clipped(what, room - text_width(far) - 1) + " " + far;
}

/// What was done on the way, the last at the end, in at most that many rows.
std::vector<std::string> done_lines(const WorkerStatus& status,
                                    int width,
                                    std::size_t rows) {
  std::string words;
  for (const std::string& stage : status.done) {
    words += (words.empty() ? "done: " : ", ") + stage;
  }
  std::vector<std::string> lines = wrapped(words, width);
  if (lines.size() > rows) {
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(rows));
    lines.front() = "… " + lines.front();
  }
  return lines;
}

}  // namespace

long seconds_of(const WorkerStatus& status) {
  if (!status.busy) return 0;
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::steady_clock::now() - status.since)
      .count();
}

std::string Program::window_title() const {
  std::string title = "tapfit";
  if (known_.bundle) title += ": " + clipped(known_.bundle->title, 60);
  if (!shown_.busy) return title;
  return fmt::format("{} % {}", std::lround(100.0 * shown_.fraction), title);
}

Screen Program::draw() const {
  if (canvas_.width < least_width || canvas_.height < least_height) {
    return too_small(canvas_);
  }
  Screen screen(canvas_);
  draw_tabs(screen);
  screen.place(0, 1, help_open_ ? help(room()) : body(room()));
  draw_line(screen, canvas_.height - 2);
  draw_keys(screen, canvas_.height - 1);
  return screen;
}

Canvas Program::room() const {
  Canvas room = canvas_;
  room.height -= frame_rows;
  return room;
}

Screen Program::drawn(const Page& page, const Canvas& canvas) const {
  return ready(page) ? page.draw(known_, canvas) : waiting(page, canvas);
}

Screen Program::body(const Canvas& canvas) const {
  Screen screen(canvas);
  draw_panes(screen);
  draw_live(screen);
  draw_palette(screen);
  if (boxed()) {
    draw_text_box(
        screen,
        "message (any key closes)",
        wrapped(message_, std::min(canvas.width - 8, 72)),
        {.colour = message_is_error_ ? Colour::Red : Colour::Default});
  }
  return screen;
}

Screen Program::waiting(const Page& page, const Canvas& canvas) const {
  Screen screen(canvas);
  const auto say = [&](const std::string& title, const std::string& words) {
    draw_text_box(
        screen, title, wrapped(words, std::min(canvas.width - 8, 72)), {});
  };
  if (lacks_input(page) && !page.wants_model()) {
    say(page.title(), page.nothing_here(*known_.bundle));
    return screen;
  }
  if (lacks_input(page)) {
    say(page.title(),
        "This bundle has no model, so there is nothing to compare with. "
        "Recording (1), FRFs (2) and modes (3) need none.\n \nTo go on, put "
        "the Nastran deck beside test.json and name it there, as in "
        "\"model\": \"model.bdf\"; or K and M of any other program as Matrix "
        "Market files. Then open the bundle again.");
    return screen;
  }
  for (const Need& need : page.essential()) {
    if (known_.has(need)) continue;
    const auto failed = failed_.find(need);
    if (failed != failed_.end()) {
      say(name(need.stage), failed->second + " (r: run again)");
      return screen;
    }
    const int width = std::min(canvas.width - 8, 72);
    const bool other = shown_.busy && shown_.title != name(need.stage);
    std::vector<std::string> lines{progress_text(shown_, width),
                                   bar(shown_.fraction, width, canvas.ascii),
                                   ""};
    for (const std::string& line : done_lines(shown_, width, 6)) {
      lines.push_back(line);
    }
    lines.emplace_back("Esc stops it; other screens stay usable.");
    draw_text_box(screen,
                  name(need.stage) + (other ? ": waiting for other work" : ""),
                  lines,
                  {});
    return screen;
  }
  return screen;
}

void Program::draw_tabs(Screen& screen) const {
  int x = 0;
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    Style style{.colour = Colour::Sky};
    style.reverse = i == current_;
    style.bold = i == current_;
    const int start = x;
    const bool beside = panes() && split_->other == i;
    x = screen.text(x, 0, tab_text(i, *pages_[i], beside), style);
    screen.zone({.rect = {start, 0, x - start, 1},
                 .kind = Zone::Kind::Key,
                 .index = U'1' + i});
  }
  const int room = screen.width() - x - 1;
  std::string words = known_.bundle ? known_.bundle->title : "";
  if (!crumbs_.empty()) {
    words.clear();
    for (const std::size_t i : crumbs_) words += pages_[i]->title() + " > ";
    words += page().title() + " (Esc back)";
  }
  if (room > 12) {
    screen.text_right(
        screen.width() - 1, 0, words, {.colour = Colour::Grey}, room);
  }
}

void Program::draw_line(Screen& screen, int y) const {
  const int width = screen.width() - 2;
  if (asked_to_replace_) return draw_question(screen, y);
  if (mode_ == Mode::Colon) {
    const int x = screen.text(0, y, ":" + typed_, {}, width);
    screen.put(x, y, U' ', {.reverse = true});
    // Of a place, what stands behind the effect's name.
    std::vector<std::string> words;
    for (const std::string& one : completions(typed_, context())) {
      words.push_back(one.substr(one.find_last_of(" @") + 1));
    }
    screen.text(
        x + 3,
        y,
        words.empty() ? "" : listed("Tab: ", words, "  ", width - x - 3),
        {.colour = Colour::Grey},
        width - x - 3);
    return;
  }
  const ListState* list = page().list();
  if (mode_ == Mode::Filter && list != nullptr) {
    const int x = screen.text(0, y, "/" + list->filter, {}, width);
    screen.put(x, y, U' ', {.reverse = true});
    return;
  }
  if (shown_.busy) return draw_work(screen, y);
  const std::string words = filter_words() + (boxed() ? "" : message_);
  if (words.empty() && (ready(page()) || lacks_input(page()))) {
    screen.text(
        1, y, step_words(current_, known_), {.colour = Colour::Grey}, width);
    return;
  }
  const Colour colour = message_is_error_ ? Colour::Red : Colour::Default;
  screen.text(1, y, words, {.colour = colour}, width);
}

std::string Program::filter_words() const {
  const ListState* list = page().list();
  if (list == nullptr || list->filter.empty()) return {};
  return fmt::format("filter /{}  (Esc clears)  ", list->filter);
}

bool Program::boxed() const {
  return !message_.empty() &&
         text_width(filter_words() + message_) > canvas_.width - 2;
}

/// What runs and how far it is; to its left what there is to tell.
void Program::draw_work(Screen& screen, int y) const {
  const int width = screen.width() - 2;
  const int bar_width = std::min(20, width / 4);
  int x = 1;
  if (!message_.empty() && !boxed()) {
    const Colour colour = message_is_error_ ? Colour::Red : Colour::Default;
    x = screen.text(1, y, message_, {.colour = colour}, width) + 2;
  }
  const int room = width - bar_width - x;
  if (room < 16) return;
  x = screen.text(x,
                  y,
                  progress_text(shown_, room - 2) + "  ",
                  {.colour = Colour::Sky},
                  room);
  screen.text(x,
              y,
              bar(shown_.fraction, bar_width, screen.ascii()),
              {.colour = Colour::Sky});
}

void Program::draw_keys(Screen& screen, int y) const {
  const std::vector<KeyHelp> always{
      {"?", "help"}, {":", "command"}, {"q", "quit"}};
  int end = screen.width();
  for (const KeyHelp& key : always) end -= key_width(key);
  screen.fill({0, y, screen.width(), 1}, U' ', {.reverse = true});
  int x = 1;
  // A long one that does not fit makes room for those behind it.
  for (const KeyHelp& key : page_keys()) {
    if (x + key_width(key) > end) continue;
    x = draw_key(screen, x, y, key);
  }
  x = end + 1;
  for (const KeyHelp& key : always) x = draw_key(screen, x, y, key);
}

}  // namespace tapfit::tui
