#include "tui/screen/pixel_pen.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

constexpr double whole = 255.0;
constexpr std::uint8_t half = 128;

/// A line lies over what was drawn before, its rim does not.
void cover(Pixel& pixel, std::uint8_t ink, std::uint8_t much) {
  const bool other = pixel.cover > 0 && pixel.ink != ink;
  if (other && much < half && pixel.cover >= much) return;
  pixel.ink = ink;
  pixel.cover = std::max(pixel.cover, much);
}

bool draws(const PixelPen& pen, int position) {
  return pen.period <= 0.0 || std::fmod(position, pen.period) < pen.drawn;
}

}  // namespace

void stroke(PixelPicture& picture,
            double x0,
            double y0,
            double x1,
            double y1,
            const PixelPen& pen) {
  // u goes the longer way.
  const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
  const double u0 = steep ? y0 : x0;
  const double v0 = steep ? x0 : y0;
  const double du = steep ? y1 - y0 : x1 - x0;
  const double dv = steep ? x1 - x0 : y1 - y0;
  const double square = du * du + dv * dv;
  const double slope = square > 0.0 ? dv / du : 0.0;
  const double radius = 0.5 * pen.width;
  const double reach = radius + 0.5;
  const double spread = reach * std::sqrt(1.0 + slope * slope);
  const int last_u = (steep ? picture.height() : picture.width()) - 1;
  const int last_v = (steep ? picture.width() : picture.height()) - 1;
  const int to_u = std::min(
      static_cast<int>(std::ceil(std::max(u0, u0 + du) + reach)), last_u);
  int u =
      std::max(static_cast<int>(std::floor(std::min(u0, u0 + du) - reach)), 0);
  for (; u <= to_u; ++u) {
    if (!draws(pen, u)) continue;
    const double middle = v0 + (u - u0) * slope;
    const int to_v =
        std::min(static_cast<int>(std::ceil(middle + spread)), last_v);
    int v = std::max(static_cast<int>(std::floor(middle - spread)), 0);
    for (; v <= to_v; ++v) {
      const double along = (u - u0) * du + (v - v0) * dv;
      const double t =
          square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
      const double away = std::hypot(u - u0 - t * du, v - v0 - t * dv);
      if (away >= reach) continue;
      const double much = std::min(reach - away, 1.0) * whole;
      cover(steep ? picture.at(v, u) : picture.at(u, v),
            pen.ink,
            static_cast<std::uint8_t>(std::lround(much)));
    }
  }
}

void dither(PixelPicture& picture,
            double from,
            double to,
            int grain,
            std::uint8_t ink) {
  const int first = std::max(static_cast<int>(std::lround(from)), 0);
  const int last =
      std::min(static_cast<int>(std::lround(to)), picture.width() - 1);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = first; x <= last; ++x) {
      if ((x / grain + 2 * (y / grain)) % 4 == 0) {
        cover(picture.at(x, y), ink, static_cast<std::uint8_t>(whole));
      }
    }
  }
}

}  // namespace tapfit::tui
