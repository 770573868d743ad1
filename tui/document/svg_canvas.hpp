// An SVG picture, drawn element by element. Coordinates are in pixels from the
// upper left, written with one decimal.
//
// Source: W3C, "Scalable Vector Graphics (SVG) 1.1".
#pragma once

#include "tui/screen/screen.hpp"

#include <string>
#include <string_view>

namespace tapfit::tui {

/// Colours that stay apart for the colour-blind.
/// Source: M. Okabe, K. Ito, "Color universal design", 2008.
namespace ink {
inline constexpr const char* black = "#1a1a1a";
inline constexpr const char* grey = "#9a9a9a";
inline constexpr const char* pale = "#dddddd";
inline constexpr const char* blue = "#0072b2";
inline constexpr const char* orange = "#d55e00";
inline constexpr const char* green = "#009e73";
inline constexpr const char* yellow = "#e69f00";
inline constexpr const char* violet = "#8250a8";
inline constexpr const char* red = "#b3261e";
inline constexpr const char* sky = "#3a9bd9";
}  // namespace ink

/// What a screen's colour is on white paper.
[[nodiscard]] const char* ink_of(Colour colour);

/// One decimal, no more digits than needed, never "-0"; 0 for what is no finite
/// number.
[[nodiscard]] std::string coordinate(double value);

struct Stroke {
  std::string colour = ink::black;
  double width = 1.0;
  std::string dash = {};    ///< stroke-dasharray
  bool round_ends = false;  ///< lines of no length become dots
};

struct Words {
  const char* anchor = "start";  ///< start, middle, end
  double size = 13.0;
  std::string colour = ink::black;
  double turn_deg = 0.0;  ///< about the point they stand at
};

class SvgCanvas {
 public:
  /// @param name what it shows, for those who do not see it
  SvgCanvas(double width, double height, std::string_view name);

  void line(double x1, double y1, double x2, double y2, const Stroke& stroke);
  void rectangle(double x,
                 double y,
                 double width,
                 double height,
                 std::string_view fill,
                 std::string_view edge = "none");
  void circle(double x, double y, double radius, std::string_view fill);
  void text(double x, double y, std::string_view words, const Words& how = {});
  /// @param d path data
  void path(std::string_view d, const Stroke& stroke);
  /// A path that swings between two shapes with the same commands and back.
  void swinging_path(std::string_view d,
                     std::string_view other,
                     const Stroke& stroke);

  [[nodiscard]] std::string svg() const { return text_ + "</svg>"; }

 private:
  std::string text_;
};

}  // namespace tapfit::tui
