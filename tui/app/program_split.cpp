// Two screens at once, and which of them the keys go to.
#include "tui/app/program.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::tui {
namespace {

Canvas with_size(Canvas canvas, const Rect& rect) {
  canvas.width = rect.width;
  canvas.height = rect.height;
  return canvas;
}

/// Points at the screen that the keys go to.
void draw_between(Screen& screen, const Panes& panes, bool to_first) {
  const Rect& line = panes.line;
  screen.fill(line, panes.beside ? U'│' : U'─', {.colour = Colour::Grey});
  const char32_t arrow =
      panes.beside ? (to_first ? U'←' : U'→') : (to_first ? U'↑' : U'↓');
  screen.put(line.x + line.width / 2,
             line.y + line.height / 2,
             arrow,
             {.colour = Colour::Sky, .bold = true});
}

}  // namespace

std::optional<Panes> Program::panes() const {
  if (!split_) return std::nullopt;
  return split_panes(room().width, room().height);
}

std::vector<std::size_t> Program::shown_screens() const {
  std::vector<std::size_t> shown{current_};
  if (panes()) shown.push_back(split_->other);
  return shown;
}

Canvas Program::focused_canvas() const {
  const std::optional<Panes> both = panes();
  if (!both) return room();
  return with_size(room(),
                   split_->other_is_second ? both->first : both->second);
}

void Program::draw_panes(Screen& screen) const {
  const Canvas canvas = focused_canvas();
  const Screen words = tour(canvas);
  Canvas above = canvas;
  above.height -= words.height();
  const std::optional<Panes> both = panes();
  const bool to_first = !both || split_->other_is_second;
  const Rect mine = !both      ? screen.area()
                    : to_first ? both->first
                               : both->second;
  screen.place(mine.x, mine.y, drawn(page(), above));
  screen.place(mine.x, mine.y + above.height, words);
  if (!both) return;
  const Rect& other = to_first ? both->second : both->first;
  screen.place(other.x,
               other.y,
               drawn(*pages_[split_->other], with_size(room(), other)));
  draw_between(screen, *both, to_first);
}

std::string Program::split_needs() const {
  return fmt::format(
      "two screens need {} x {} cells beside each other or {} x {} one above "
      "the other; this is {} x {}",
      2 * least_width + 1,
      least_height,
      least_width,
      2 * (least_height - frame_rows) + 1 + frame_rows,
      canvas_.width,
      canvas_.height);
}

void Program::split(std::optional<std::size_t> other) {
  const std::size_t next = (current_ + 1) % pages_.size();
  const std::size_t wanted =
      other.value_or(before_ == current_ ? next : before_);
  if (wanted == current_) {
    return tell("that screen is shown: name another", true);
  }
  const bool second = !split_ || split_->other_is_second;
  if (!split_panes(room().width, room().height)) return tell(split_needs());
  split_ = Split{wanted, second};
}

void Program::end_split(bool keep_focused) {
  if (!split_) return tell("one screen is shown");
  if (!keep_focused) change_focus();
  split_.reset();
}

void Program::change_focus() {
  screen_chosen_ = true;
  if (!split_) return tell("one screen is shown; | shows another beside it");
  std::swap(current_, split_->other);
  split_->other_is_second = !split_->other_is_second;
  if (mode_ == Mode::Filter) mode_ = Mode::Normal;
}

void Program::focus_at(int x, int y) {
  const std::optional<Panes> both = panes();
  if (!both) return;
  const Rect& other = split_->other_is_second ? both->second : both->first;
  if (other.holds(x, y - 1)) change_focus();  // below the tabs
}

void Program::press_after_window_key(Key key) {
  const bool first =
      key == U'h' || key == U'k' || key == keys::left || key == keys::up;
  const bool second =
      key == U'l' || key == U'j' || key == keys::right || key == keys::down;
  if (key == U'w' || key == U'p' || key == Key(U'w', true)) {
    change_focus();
  } else if (first || second) {
    if (!split_ || split_->other_is_second == second) change_focus();
  } else if (key == U'v' || key == U's') {
    split(std::nullopt);
  } else if (key == U'o') {
    end_split(true);
  } else if (key == U'c') {
    end_split(false);
  }
}

}  // namespace tapfit::tui
