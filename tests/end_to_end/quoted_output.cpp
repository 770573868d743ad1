#include "tests/end_to_end/quoted_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace tapfit::end_to_end {
namespace {

const std::string indent = "    ";
const std::string prompt = indent + "tapfit ";

bool is_empty(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

struct Number {
  double value = 0.0;
  double unit = 1.0;  // of its last digit
};

// Also "12," and "(81.5".
std::optional<Number> number_in(std::string word) {
  std::erase_if(word, [](char c) { return c == '(' || c == ')' || c == ','; });
  char* end = nullptr;
  Number number;
  number.value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') return std::nullopt;
  const std::size_t power = word.find_first_of("eE");
  const std::string digits = word.substr(0, power);
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) {
    const auto decimals = digits.size() - point - 1;
    number.unit = std::pow(10.0, -static_cast<double>(decimals));
  }
  if (power != std::string::npos) {
    number.unit *= std::pow(10.0, std::stod(word.substr(power + 1)));
  }
  return number;
}

bool same_word(const std::string& quoted, const std::string& printed) {
  if (quoted == printed) return true;
  const auto one = number_in(quoted);
  const auto other = number_in(printed);
  if (!one || !other) return false;
  constexpr double share = 0.01;
  const double apart = std::max(1.1 * one->unit, share * std::abs(one->value));
  return std::abs(one->value - other->value) <= apart;
}

bool same_line(const std::string& quoted, const std::string& printed) {
  return std::ranges::equal(words_of(quoted), words_of(printed), same_word);
}

}  // namespace

std::vector<QuotedCommand> quoted_commands(const std::string& page) {
  std::vector<QuotedCommand> commands;
  bool follows = false;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with(prompt)) {
      commands.push_back({line.substr(prompt.size()), {}});
      follows = true;
    } else if (!is_empty(line)) {
      follows = follows && line.starts_with(indent);
      if (follows) commands.back().printed.push_back(line);
    }
  }
  return commands;
}

std::string not_printed(const std::vector<std::string>& quoted,
                        const std::string& output) {
  std::vector<std::string> printed = lines_of(output);
  std::erase_if(printed, is_empty);
  auto next = printed.begin();
  bool skips = false;
  for (const std::string& line : quoted) {
    if (words_of(line) == std::vector<std::string>{"..."}) {
      skips = true;
      continue;
    }
    const auto last = skips || next == printed.end() ? printed.end() : next + 1;
    const auto found = std::find_if(next, last, [&line](const auto& other) {
      return same_line(line, other);
    });
    if (found == last) return line;
    next = found + 1;
    skips = false;
  }
  return {};
}

}  // namespace tapfit::end_to_end
