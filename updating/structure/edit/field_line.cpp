#include "updating/structure/edit/field_line.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/line_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tapfit::structure {
namespace {

constexpr std::size_t small_width = 8;
constexpr std::size_t last_column = 72;  // behind it the marker

std::vector<std::string> between_commas(const std::string& text) {
  std::vector<std::string> cells;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    cells.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
  return cells;
}

// With a point, and an exponent without its letter: 7.12+10.
std::string short_real(std::string text) {
  const std::size_t e = std::min(text.find('e'), text.size());
  std::string exponent = text.substr(std::min(e + 1, text.size()));
  text.resize(e);
  if (text.find('.') == std::string::npos) text += '.';
  if (exponent.empty()) return text;
  const std::size_t digit = exponent.find_first_not_of("+-0");
  return text + exponent.front() + exponent.substr(digit);
}

}  // namespace

std::string real_in(double value, std::size_t width) {
  constexpr int most = 10;
  if (value == 0.0) return "0.";
  const int power = static_cast<int>(std::floor(std::log10(std::abs(value))));
  for (int digits = most; digits > 1; --digits) {
    const int shift = power - digits + 1;
    for (const std::string& text :
         {short_real(fmt::format("{:.{}g}", value, digits)),
          fmt::format("{:.0f}.{:+d}", value / std::pow(10.0, shift), shift)}) {
      if (text.size() <= width) return text;
    }
  }
  return short_real(fmt::format("{:.1g}", value));
}

FieldLine FieldLine::of_card(const std::string& written) {
  FieldLine line;
  const std::string body = without_comment(written);
  line.behind_ = written.substr(body.size());
  if (body.find(',') != std::string::npos) {
    line.cells_ = between_commas(body);
    return line;
  }
  const std::string text = expand_tabs(body);
  line.cells_.push_back(text.substr(0, small_width));
  const bool large = line.cells_[0].find('*') != std::string::npos;
  line.width_ = (large ? 2 : 1) * small_width;
  std::size_t at = small_width;
  while (at < text.size()) {
    const std::size_t width = at < last_column ? line.width_ : small_width;
    line.cells_.push_back(text.substr(at, width));
    at += width;
  }
  return line;
}

FieldLine FieldLine::of_keyword(const std::string& written) {
  FieldLine line;
  line.cells_ = between_commas(written);
  return line;
}

std::size_t FieldLine::data_fields() const {
  const bool large =
      !cells_.empty() && cells_[0].find('*') != std::string::npos;
  return large ? 4 : 8;
}

FieldLine FieldLine::continuation() const {
  FieldLine line;
  line.width_ = width_;
  const std::string marker = field(data_fields() + 1);
  const char* usual = data_fields() == 4 ? "*" : width_ == 0 ? "" : "+";
  const bool marked = !marker.empty() && marker.starts_with(usual);
  line.cells_ = {marked ? marker : usual};
  if (width_ == 0) line.cells_.emplace_back();  // a blank line is none
  return line;
}

std::string FieldLine::field(std::size_t k) const {
  return k < cells_.size() ? trimmed(cells_[k]) : "";
}

void FieldLine::set(std::size_t k, const std::string& text) {
  if (cells_.size() <= k) cells_.resize(k + 1);
  std::string& cell = cells_[k];
  if (width_ == 0) {
    const std::size_t blanks = cell.find_first_not_of(" \t");
    const bool led = blanks != std::string::npos && blanks > 0;
    cell = (led ? cell.substr(0, blanks) : "") + text;
    return;
  }
  std::string fitting = text;
  const std::optional<double> value = parse_real(text);
  if (text.size() > width_ && value) fitting = real_in(*value, width_);
  const bool right =
      cell.size() == width_ && cell.front() == ' ' && cell.back() != ' ';
  cell = right ? fmt::format("{:>{}}", fitting, width_) : fitting;
}

void FieldLine::set_name(const std::string& name) {
  cells_[0] = name + (data_fields() == 4 ? "*" : "");
}

void FieldLine::drop_marker() {
  const std::size_t marker = data_fields() + 1;
  if (cells_.size() > marker) cells_.resize(marker);
  if (cells_[0].starts_with('+')) cells_[0] = "+";
  if (cells_[0].starts_with('*')) cells_[0] = "*";
}

std::string FieldLine::text() const {
  std::string text;
  if (width_ == 0) {
    text = fmt::format("{}", fmt::join(cells_, ","));
  } else {
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const std::size_t width = k == 0 ? small_width : width_;
      text += fmt::format("{:<{}}", cells_[k], width);
    }
    text.erase(text.find_last_not_of(' ') + 1);
  }
  if (behind_.empty()) return text;
  const bool apart = text.ends_with(' ') || text.ends_with('\t');
  return text + (apart ? "" : " ") + behind_;
}

}  // namespace tapfit::structure
