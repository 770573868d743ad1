#include "tui/screen/graphics_question.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace tapfit::tui {
namespace {

constexpr int sixel_attribute = 4;  // of DA1
constexpr int cell_report = 6;      // of CSI ... t

bool begins_with_any(std::string_view kind,
                     std::initializer_list<std::string_view> names) {
  return std::ranges::any_of(
      names, [kind](std::string_view name) { return kind.starts_with(name); });
}

/// "62;4;22"; what is no number counts as 0.
std::vector<int> numbers_of(std::string_view text) {
  std::vector<int> numbers;
  while (true) {
    const std::size_t end = text.find(';');
    const std::string_view part = text.substr(0, end);
    int number = 0;
    std::from_chars(part.data(), part.data() + part.size(), number);
    numbers.push_back(number);
    if (end == std::string_view::npos) return numbers;
    text.remove_prefix(end + 1);
  }
}

/// Length of the sequence "ESC [ ... final" at the beginning, 0 where it is
/// none or has not ended.
std::size_t control_length(std::string_view bytes) {
  if (!bytes.starts_with("\033[")) return 0;
  for (std::size_t i = 2; i < bytes.size(); ++i) {
    if (bytes[i] >= 0x40 && bytes[i] <= 0x7E) return i + 1;
  }
  return 0;
}

/// @return false where it is no answer
bool take_control(std::string_view sequence, GraphicsAnswer& answer) {
  const char final = sequence.back();
  std::string_view inside = sequence.substr(2, sequence.size() - 3);
  if (final == 'c' && inside.starts_with('?')) {
    inside.remove_prefix(1);
    const std::vector<int> has = numbers_of(inside);
    // The first is what terminal it is.
    answer.sixel = std::count(has.begin() + 1, has.end(), sixel_attribute) > 0;
    answer.complete = true;
    return true;
  }
  if (final != 't') return false;
  const std::vector<int> report = numbers_of(inside);
  if (report.size() == 3 && report[0] == cell_report) {
    answer.cell = {report[2], report[1]};
  }
  return true;
}

}  // namespace

std::string graphics_question(std::string_view kind) {
  const std::string size = "\033[16t";
  const std::string attributes = "\033[c";
  if (kind.empty() || kind == "dumb") return {};
  if (begins_with_any(kind, {"linux", "vt", "screen", "tmux", "rxvt"})) {
    return size + attributes;
  }
  return "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\" + size + attributes;
}

GraphicsAnswer read_graphics_answer(std::string_view bytes) {
  constexpr std::string_view kitty = "\033_G";
  constexpr std::string_view string_end = "\033\\";
  GraphicsAnswer answer;
  while (!bytes.empty()) {
    std::size_t length = control_length(bytes);
    if (length > 0 && take_control(bytes.substr(0, length), answer)) {
      bytes.remove_prefix(length);
      continue;
    }
    const std::size_t end =
        bytes.starts_with(kitty) ? bytes.find(string_end) : bytes.npos;
    if (end != bytes.npos) {
      answer.kitty = answer.kitty || bytes.substr(0, end).ends_with(";OK");
      bytes.remove_prefix(end + string_end.size());
      continue;
    }
    length = std::max<std::size_t>(length, 1);
    answer.typed += bytes.substr(0, length);
    bytes.remove_prefix(length);
  }
  return answer;
}

}  // namespace tapfit::tui
