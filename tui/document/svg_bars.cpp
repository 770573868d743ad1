#include "tui/document/svg_bars.hpp"

#include "tui/document/svg_canvas.hpp"
#include "tui/widgets/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

constexpr double picture_width = 420.0;
constexpr double bars_left = 4.0;
constexpr double bars_right = 352.0;
constexpr double bar_pitch = 38.0;  // a line of words and the bar below it
constexpr double words_height = 17.0;
constexpr double bar_height = 16.0;
constexpr std::size_t most_letters = 62;

struct BarScale {
  double low = 1.0;
  double high = 10.0;

  [[nodiscard]] double operator()(double value) const {
    const double share = std::log(value / low) / std::log(high / low);
    return bars_left + std::clamp(share, 0.0, 1.0) * (bars_right - bars_left);
  }
};

BarScale scale_of(const std::vector<SvgBar>& bars, double factor) {
  double low = 0.0;
  double high = 0.0;
  for (const SvgBar& bar : bars) {
    const double value = factor * bar.value;
    if (!std::isfinite(value) || value <= 0.0) continue;
    low = low == 0.0 ? value : std::min(low, value);
    high = std::max(high, value);
  }
  if (high == 0.0) return {};
  // Every bar has some length.
  return {std::min(low, high / 10.0) / 2.0, high};
}

/// The start of what does not fit, and a sign that it goes on.
std::string shortened(const std::string& text, std::size_t most) {
  std::size_t letters = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if ((static_cast<unsigned char>(text[k]) & 0xC0U) == 0x80U) continue;
    if (letters == most) return text.substr(0, k) + "…";
    ++letters;
  }
  return text;
}

}  // namespace

std::string svg_bars(const std::vector<SvgBar>& bars,
                     const std::string& name,
                     const std::string& axis,
                     double factor) {
  const BarScale scale = scale_of(bars, factor);
  const double bottom = 6.0 + bar_pitch * static_cast<double>(bars.size());
  SvgCanvas canvas(picture_width, bottom + 40.0, name);
  for (const Tick& tick : ticks(scale.low, scale.high, true, 5)) {
    const double x = scale(tick.value);
    canvas.line(x, 4.0, x, bottom, {ink::pale});
    canvas.text(
        x, bottom + 15.0, tick.label, {.anchor = "middle", .size = 12.0});
  }
  canvas.text((bars_left + bars_right) / 2.0,
              bottom + 34.0,
              axis,
              {.anchor = "middle"});
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const SvgBar& bar = bars[k];
    const double y = 6.0 + bar_pitch * static_cast<double>(k);
    canvas.text(bars_left + 2.0,
                y + 12.5,
                shortened(bar.label, most_letters),
                {.size = 12.5});
    const bool drawn = std::isfinite(bar.value) && bar.value > 0.0;
    const double end = drawn ? scale(factor * bar.value) : bars_left;
    canvas.rectangle(
        bars_left, y + words_height, end - bars_left, bar_height, bar.colour);
    canvas.text(
        end + 6.0, y + words_height + 12.0, bar.written, {.size = 12.5});
  }
  canvas.line(bars_left, 4.0, bars_left, bottom, {ink::grey});
  return canvas.svg();
}

}  // namespace tapfit::tui
