#include "tui/widgets/bars.hpp"

#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

std::string bar(double share, int width, bool ascii) {
  if (width <= 0) return {};
  const double part = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  const int eighths = static_cast<int>(std::lround(part * 8.0 * width));
  std::string text;
  for (int i = 0; i < width; ++i) {
    const int here = std::clamp(eighths - 8 * i, 0, 8);
    if (ascii) {
      text += here >= 4 ? '#' : '.';
    } else if (here == 0) {
      text += ' ';
    } else {
      append_utf8(text, static_cast<char32_t>(U'█' + (8 - here)));
    }
  }
  return text;
}

std::string times_floor(double error, double floor) {
  const double times = error / floor;
  return times < 9.95 ? fixed(times, 1) : number(times, 2);
}

std::string against_floor(double error, double floor) {
  if (error <= floor) return "within the floor";
  if (!(floor > 0.0)) return "without a floor to compare with";
  return times_floor(error, floor) + " times the floor" +
         (error <= near_floor * floor ? ", as good as the data allow" : "");
}

void draw_error_bar(Screen& screen,
                    const Rect& line,
                    double error,
                    double floor,
                    double scale) {
  if (line.empty() || !(scale > 0.0)) return;
  const Colour colour =
      error <= near_floor * floor ? Colour::Green : Colour::Orange;
  screen.text(line.x,
              line.y,
              bar(error / scale, line.width, screen.ascii()),
              {.colour = colour},
              line.width);
  if (!std::isfinite(floor) || floor <= 0.0 || floor > scale) return;
  const int at =
      static_cast<int>(std::lround(floor / scale * (line.width - 1)));
  screen.put(line.x + at, line.y, U'│', {.colour = Colour::Sky, .bold = true});
}

}  // namespace tapfit::tui
