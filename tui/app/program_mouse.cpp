// What the mouse means: clicks on what stands there, drags and the wheel over
// plots.
#include "tui/app/program.hpp"

#include <algorithm>
#include <cstdlib>

namespace tapfit::tui {

void Program::mouse(Key key) {
  const Screen screen = draw();
  const Zone* zone = screen.zone_at(key.x, key.y);
  if (zone == nullptr) return focus_at(key.x, key.y);
  if (zone->kind == Zone::Kind::Key) {
    const Key meant(static_cast<char32_t>(zone->index), zone->column != 0);
    return press_normal(meant);
  }
  if (zone->kind == Zone::Kind::Command) return choose_command(zone->index);
  focus_at(key.x, key.y);
  if (!ready(page())) return;
  if (zone->kind == Zone::Kind::PlotX) held_ = Held{*zone, key.x};
  page().click(known_, *zone, key.x);
}

void Program::drag(const std::optional<Held>& from, Key to) {
  constexpr int least = 2;  // cells; less is a click
  PlotRange* range = page().range();
  if (!from || range == nullptr) return;
  const Rect& rect = from->plot.rect;
  const int x = std::clamp(to.x, rect.x, rect.x + rect.width - 1);
  if (std::abs(x - from->x) < least) return;
  const double one = from->plot.value_at(from->x);
  const double other = from->plot.value_at(x);
  range->lo = std::min(one, other);
  range->hi = std::max(one, other);
}

bool Program::zoom_by_wheel(Key key) {
  const bool closer = key.code == keys::wheel_up;
  if (!closer && key.code != keys::wheel_down) return false;
  if (mode_ != Mode::Normal) return false;
  focus_at(key.x, key.y);
  if (!ready(page())) return false;
  const Screen screen = draw();
  const Zone* zone = screen.zone_at(key.x, key.y);
  if (zone == nullptr || zone->kind != Zone::Kind::PlotX) return false;
  Command none;
  return page().click(known_, *zone, key.x) &&
         page().press(known_, closer ? U'+' : U'-', none);
}

}  // namespace tapfit::tui
