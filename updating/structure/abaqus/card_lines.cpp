#include "updating/structure/abaqus/card_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

std::string real_field(double value) {
  constexpr std::size_t widest = 16;
  // The shortest that is the same number, else as many digits as have room.
  std::string text = fmt::format("{}", value);
  for (int digits = 16;; --digits) {
    if (text.find('.') == std::string::npos) {
      text.insert(std::min(text.find('e'), text.size()), ".");
    }
    if (text.size() <= widest) return text;
    text = fmt::format("{:.{}g}", value, digits);
  }
}

}  // namespace

CardField::CardField(int value) : text(fmt::format("{}", value)) {}

CardField::CardField(double value) : text(real_field(value)) {}

void add_vector(CardFields& fields, const Eigen::Vector3d& v) {
  for (const double x : v) fields.emplace_back(x);
}

void CardLines::comment(const std::string& text, const Place& place) {
  lines_.push_back({"$ " + text, place.where, place.number, place.index});
}

void CardLines::card(const Place& place,
                     const std::string& name,
                     const CardFields& fields) {
  constexpr std::size_t small = 8;
  const bool large = std::ranges::any_of(
      fields, [](const CardField& f) { return f.text.size() > small; });
  const std::size_t per_line = large ? 4 : 8;
  const std::size_t width = large ? 2 * small : small;
  std::size_t end = fields.size();
  while (end > 1 && fields[end - 1].text.empty()) --end;
  for (std::size_t at = 0; at < end; at += per_line) {
    std::string text = fmt::format(
        "{:<8}",
        at == 0 ? name + (large ? "*" : "") : std::string(large ? "*" : "+"));
    for (std::size_t k = at; k < std::min(at + per_line, end); ++k) {
      text += fmt::format("{:<{}}", fields[k].text, width);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    lines_.push_back({std::move(text), place.where, place.number, place.index});
  }
}

}  // namespace tapfit::structure
