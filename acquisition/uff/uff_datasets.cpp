#include "acquisition/uff/uff_datasets.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace tapfit::acquisition {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

// Walks through the text line by line.
struct Lines {
  std::string_view text;
  const std::string& name;
  const std::function<void(std::string_view)>& passed;
  std::size_t at = 0;
  std::size_t told = 0;
  int number = 0;

  [[nodiscard]] bool done() const { return at >= text.size(); }
  std::string_view next() {
    ++number;
    constexpr std::size_t now_and_then = 16 << 20;
    if (passed && at - told > now_and_then) {
      passed(text.substr(told, at - told));
      told = at;
    }
    // Records have 80 characters; the zeros of a file that was not written to
    // its end are one line, maybe a terabyte of it.
    constexpr std::size_t longest = 1 << 20;
    const std::string_view near = text.substr(0, at + longest);
    const std::string_view line = next_line(near, at);
    if (at > near.size() && near.size() < text.size()) {
      throw InputError(fmt::format("a line has more than {} bytes", longest),
                       fmt::format("{}, line {}", name, number),
                       "check that this is a universal file, and whole");
    }
    return line;
  }
};

bool is_fence(std::string_view line) { return trim(line) == "-1"; }

void read_binary(Lines& lines, std::string_view header, UffDataset& dataset) {
  if (integer(column(header, 13, 6)) != 2)
    throw InputError("a binary dataset is not in IEEE 754 floating point",
                     dataset.place,
                     "export it in IEEE format or as ASCII");
  dataset.binary = true;
  dataset.big_endian = integer(column(header, 7, 6)) == 2;
  const int text_lines = integer(column(header, 19, 12));
  double size = 0.0;
  if (!parse_number(column(header, 31, 12), size) || size < 0.0 ||
      text_lines < 0)
    throw InputError("a binary dataset does not say how long it is",
                     dataset.place,
                     "export it anew or as ASCII");
  for (int i = 0; i < text_lines && !lines.done(); ++i)
    dataset.lines.push_back(lines.next());
  const std::size_t left = lines.done() ? 0 : lines.text.size() - lines.at;
  if (size > static_cast<double>(left))
    throw InputError(
        fmt::format(
            "a binary dataset ends after {} of {:.0f} bytes", left, size),
        dataset.place,
        "the file is cut off; export it anew");
  const std::size_t bytes = static_cast<std::size_t>(size);
  // The last header line may have ended with the file, without a line end.
  lines.at = std::min(lines.at, lines.text.size());
  dataset.data = lines.text.substr(lines.at, bytes);
  lines.at += bytes;
  lines.told = lines.at;
}

// What stands in text up to the closing line.
void read_text(Lines& lines, UffDataset& dataset) {
  const bool function = dataset.type == 58;
  std::size_t data = 0;
  std::size_t line_begin = lines.at;
  for (; !lines.done(); line_begin = lines.at) {
    const std::string_view line = lines.next();
    if (is_fence(line)) break;
    if (!function || dataset.lines.size() < function_header_lines) {
      dataset.lines.push_back(line);
      data = lines.at;
    }
  }
  if (!function) return;
  // The last line may have ended with the file.
  line_begin = std::min(line_begin, lines.text.size());
  data = std::min(data, line_begin);
  dataset.data = lines.text.substr(data, line_begin - data);
}

// A binary dataset's closing line.
void pass_fence(Lines& lines) {
  while (!lines.done() && !is_fence(lines.next())) {
  }
}

bool is_sign(char c) { return c == '+' || c == '-'; }

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// What from_chars() makes of a whole text. Too small for a double is nothing;
// too large is no measurement.
bool to_value(const std::string& plain, double& value) {
  const char* end = plain.data() + plain.size();
  const auto result = std::from_chars(plain.data(), end, value);
  if (result.ec == std::errc::result_out_of_range) {
    const std::size_t e = plain.find('e');
    const bool tiny = e != std::string::npos && plain[e + 1] == '-';
    value = tiny ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  return result.ec == std::errc() && result.ptr == end;
}

// The usual case: a finite number as C++ knows them, and nothing else.
bool is_plain(std::string_view text, double& value) {
  const char* end = text.data() + text.size();
  double plain = 0.0;
  const auto result = std::from_chars(text.data(), end, plain);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(plain)) {
    return false;
  }
  value = plain;
  return true;
}

// Number at the start of a text and how many characters it takes, 0 for none.
// An exponent may follow E, D or its sign alone.
std::size_t scan_number(std::string_view text, double& value) {
  std::size_t i = 0;
  const auto more = [&] { return i < text.size(); };
  std::string plain;
  if (more() && is_sign(text[0])) {
    if (text[0] == '-') plain += '-';
    ++i;
  }
  while (more() && (is_digit(text[i]) || text[i] == '.')) plain += text[i++];
  const bool letter =
      more() && std::string_view("EeDd").find(text[i]) != std::string::npos;
  const bool digits = std::any_of(plain.begin(), plain.end(), is_digit);
  if (digits && more() && (letter || is_sign(text[i]))) {
    plain += 'e';
    if (letter) ++i;
    if (more() && is_sign(text[i])) plain += text[i++];
    while (more() && is_digit(text[i])) plain += text[i++];
  }
  return to_value(plain, value) ? i : 0;
}

bool by_blanks(std::string_view line, std::vector<double>& values) {
  std::size_t at = 0;
  for (;;) {
    const std::size_t begin = line.find_first_not_of(blanks, at);
    if (begin == std::string_view::npos) return true;
    at = std::min(line.find_first_of(blanks, begin), line.size());
    double value = 0.0;
    if (!parse_number(line.substr(begin, at - begin), value)) return false;
    values.push_back(value);
  }
}

bool by_columns(std::string_view line,
                std::size_t width,
                std::vector<double>& values) {
  for (std::size_t at = 0; at < line.size(); at += width) {
    const std::string_view field = column(line, at, width);
    if (field.empty()) continue;
    double value = 0.0;
    if (!parse_number(field, value)) return false;
    values.push_back(value);
  }
  return true;
}

// Numbers that touch, told apart by the sign that follows an exponent.
bool by_signs(std::string_view line, std::vector<double>& values) {
  for (;;) {
    line = trim(line);
    if (line.empty()) return true;
    double value = 0.0;
    const std::size_t length = scan_number(line, value);
    if (length == 0) return false;
    values.push_back(value);
    line.remove_prefix(length);
  }
}

}  // namespace

std::vector<UffDataset> split_uff(
    std::string_view text,
    const std::string& name,
    const std::function<void(std::string_view)>& passed) {
  std::vector<UffDataset> datasets;
  Lines lines{text, name, passed};
  while (!lines.done()) {
    if (!is_fence(lines.next())) continue;
    std::string_view header = lines.done() ? "" : lines.next();
    // Two fences in a row: the first one closed nothing.
    while (is_fence(header) && !lines.done()) header = lines.next();
    if (trim(header).empty() && lines.done()) break;
    UffDataset dataset;
    dataset.place = fmt::format("{}, line {}", name, lines.number);
    dataset.type = integer(column(header, 0, 6));
    if (dataset.type <= 0)
      throw InputError("a dataset has no type",
                       dataset.place,
                       "check that this is a universal file");
    const std::string_view mark = column(header, 6, 1);
    if (mark == "b" || mark == "B") {
      read_binary(lines, header, dataset);
      pass_fence(lines);
    } else {
      read_text(lines, dataset);
    }
    datasets.push_back(std::move(dataset));
  }
  return datasets;
}

std::string_view next_line(std::string_view text, std::size_t& at) {
  const std::size_t end = std::min(text.find('\n', at), text.size());
  std::string_view line = text.substr(at, end - at);
  at = end + 1;
  while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view column(std::string_view line,
                        std::size_t begin,
                        std::size_t width) {
  return begin < line.size() ? trim(line.substr(begin, width))
                             : std::string_view{};
}

bool parse_number(std::string_view text, double& value) {
  if (text.empty()) return false;
  if (is_plain(text, value)) return true;
  std::string lower;
  for (const char c : text.substr(0, 4))
    if (c != '+' && c != '-')
      lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (lower.starts_with("nan") || lower.starts_with("inf")) {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  return scan_number(text, value) == text.size();
}

int integer(std::string_view text) {
  double value = 0.0;
  if (!parse_number(text, value) || !(std::abs(value) < 2e9)) return 0;
  return static_cast<int>(value);
}

bool numbers(std::string_view line,
             std::size_t width,
             std::vector<double>& values) {
  const std::size_t before = values.size();
  if (by_blanks(line, values)) return true;
  values.resize(before);
  if (by_columns(line, width, values)) return true;
  values.resize(before);
  return by_signs(line, values);
}

}  // namespace tapfit::acquisition
