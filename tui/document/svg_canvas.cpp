#include "tui/document/svg_canvas.hpp"

#include "tui/document/markup_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::tui {
namespace {

std::string stroke_of(const Stroke& stroke) {
  std::string text = fmt::format("fill=\"none\" stroke=\"{}\"", stroke.colour);
  if (stroke.width != 1.0) {
    text += fmt::format(" stroke-width=\"{}\"", coordinate(stroke.width));
  }
  if (!stroke.dash.empty()) {
    text += fmt::format(" stroke-dasharray=\"{}\"", stroke.dash);
  }
  text += stroke.round_ends ? " stroke-linecap=\"round\""
                            : " stroke-linejoin=\"round\"";
  return text;
}

}  // namespace

const char* ink_of(Colour colour) {
  switch (colour) {
    case Colour::Blue:
      return ink::blue;
    case Colour::Orange:
      return ink::orange;
    case Colour::Green:
      return ink::green;
    case Colour::Red:
      return ink::red;
    case Colour::Purple:
      return ink::violet;
    case Colour::Sky:
      return ink::sky;
    case Colour::Yellow:
      return ink::yellow;
    case Colour::Grey:
      return ink::grey;
    case Colour::Default:
      break;
  }
  return ink::black;
}

std::string coordinate(double value) {
  const double tenths = std::round(10.0 * value);
  if (!std::isfinite(tenths) || tenths == 0.0) return "0";
  std::string text = fmt::format("{:.1f}", tenths / 10.0);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

SvgCanvas::SvgCanvas(double width, double height, std::string_view name)
    : text_(fmt::format(
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
          "width=\"{0}\" height=\"{1}\" role=\"img\" "
          "font-family=\"Helvetica,Arial,sans-serif\"><title>{2}</title>\n",
          coordinate(width),
          coordinate(height),
          escaped(name))) {}

void SvgCanvas::line(
    double x1, double y1, double x2, double y2, const Stroke& stroke) {
  path(fmt::format("M{} {}L{} {}",
                   coordinate(x1),
                   coordinate(y1),
                   coordinate(x2),
                   coordinate(y2)),
       stroke);
}

void SvgCanvas::rectangle(double x,
                          double y,
                          double width,
                          double height,
                          std::string_view fill,
                          std::string_view edge) {
  text_ += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
      "stroke=\"{}\"/>\n",
      coordinate(x),
      coordinate(y),
      coordinate(width),
      coordinate(height),
      fill,
      edge);
}

void SvgCanvas::circle(double x,
                       double y,
                       double radius,
                       std::string_view fill) {
  text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n",
                       coordinate(x),
                       coordinate(y),
                       coordinate(radius),
                       fill);
}

void SvgCanvas::text(double x,
                     double y,
                     std::string_view words,
                     const Words& how) {
  const std::string at = coordinate(x) + " " + coordinate(y);
  text_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" "
      "fill=\"{}\"{}>{}</text>\n",
      coordinate(x),
      coordinate(y),
      coordinate(how.size),
      how.anchor,
      how.colour,
      how.turn_deg == 0.0
          ? ""
          : fmt::format(
                " transform=\"rotate({} {})\"", coordinate(how.turn_deg), at),
      escaped(words));
}

void SvgCanvas::path(std::string_view d, const Stroke& stroke) {
  text_ += fmt::format("<path d=\"{}\" {}/>\n", d, stroke_of(stroke));
}

void SvgCanvas::swinging_path(std::string_view d,
                              std::string_view other,
                              const Stroke& stroke) {
  text_ += fmt::format(
      "<path d=\"{0}\" {2}><animate attributeName=\"d\" dur=\"1.6s\" "
      "repeatCount=\"indefinite\" calcMode=\"spline\" keyTimes=\"0;.5;1\" "
      "keySplines=\".37 0 .63 1;.37 0 .63 1\" "
      "values=\"{0};{1};{0}\"/></path>\n",
      d,
      other,
      stroke_of(stroke));
}

}  // namespace tapfit::tui
