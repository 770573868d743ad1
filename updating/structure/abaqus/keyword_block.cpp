#include "updating/structure/abaqus/keyword_block.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/trimmed_text.hpp"
#include "acquisition/foundation/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

namespace tapfit::structure {
namespace {

std::string without_blanks(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

// One blank between words.
std::string with_single_blanks(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (blank && (result.empty() || result.back() == ' ')) continue;
    result += blank ? ' ' : c;
  }
  return trimmed(result);
}

std::string without_quotes(std::string text) {
  std::erase_if(text, [](char c) { return c == '"' || c == '\''; });
  return trimmed(text);
}

// Between commas; a comma at the end begins no field.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> fields;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    fields.push_back(trimmed(text.substr(from, comma - from)));
    from = comma + 1;
  }
  if (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

void take_options(const std::string& text, Keyword& keyword) {
  for (const std::string& field : split(text)) {
    if (field.empty()) continue;
    const std::size_t equals = std::min(field.find('='), field.size());
    const std::string value =
        equals < field.size() ? field.substr(equals + 1) : "";
    keyword.options[upper(without_blanks(field.substr(0, equals)))] =
        without_quotes(value);
  }
}

Keyword begin_keyword(const PlacedLine& line, std::size_t index, int step) {
  Keyword keyword;
  const std::string text = trimmed(line.text).substr(1);
  const std::size_t comma = std::min(text.find(','), text.size());
  keyword.shown = upper(with_single_blanks(text.substr(0, comma)));
  keyword.name = without_blanks(keyword.shown);
  keyword.place = {line.where, line.number, index};
  keyword.step = step;
  if (comma < text.size()) take_options(text.substr(comma + 1), keyword);
  return keyword;
}

// As data do, and no option.
bool begins_with_number(const std::string& text) {
  return std::string_view("+-.0123456789").find(text.front()) !=
         std::string_view::npos;
}

// All of the text as a number.
template <typename Number>
std::optional<Number> parsed(const std::string& text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] =
      std::from_chars(text.data() + (plus ? 1 : 0), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

[[noreturn]] void refuse_field(const DataLine& line,
                               std::size_t field,
                               const char* meaning,
                               const char* needed) {
  fail_at(line.place,
          fmt::format("field {} ({}) is \"{}\", {} is needed",
                      field + 1,
                      meaning,
                      shortened(line.text(field)),
                      needed),
          "Correct the field.");
}

}  // namespace

const std::string& DataLine::text(std::size_t field) const {
  static const std::string none;
  return field < fields.size() ? fields[field] : none;
}

std::string DataLine::name(std::size_t field) const {
  return upper(without_quotes(text(field)));
}

bool Keyword::has(const std::string& option) const {
  return options.contains(option);
}

std::string Keyword::option(const std::string& wanted) const {
  const auto found = options.find(wanted);
  return found == options.end() ? "" : upper(found->second);
}

std::string Keyword::needed_option(const std::string& wanted) const {
  const std::string value = option(wanted);
  if (value.empty()) {
    fail(fmt::format("it names no {}", wanted),
         fmt::format("Write *{}, {}=...", shown, wanted));
  }
  return value;
}

double Keyword::option_number(const std::string& wanted) const {
  const DataLine as_field{{option(wanted)}, place, false};
  return number_or(as_field, 0, 0.0, wanted.c_str());
}

const DataLine& Keyword::line(std::size_t k, const char* meaning) const {
  if (k >= lines.size()) {
    fail(fmt::format("its data line {} ({}) is missing", k + 1, meaning),
         "Write it below the keyword.");
  }
  return lines[k];
}

void Keyword::fail(const std::string& what, const std::string& remedy) const {
  throw InputError(what, place.where + " *" + shortened(shown), remedy);
}

bool is_keyword_line(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first != std::string::npos && text[first] == '*' &&
         first + 1 < text.size() &&
         std::isalpha(static_cast<unsigned char>(text[first + 1])) != 0;
}

std::optional<std::string> included_by_keyword(const std::string& text) {
  if (!is_keyword_line(text)) return {};
  const Keyword keyword = begin_keyword({text, "", 0}, 0, 0);
  if (keyword.name != "INCLUDE" || keyword.option("INPUT").empty()) return {};
  return keyword.options.at("INPUT");
}

std::vector<Keyword> keyword_blocks(const std::vector<PlacedLine>& lines) {
  std::vector<Keyword> blocks;
  int steps = 0;
  int step = 0;
  bool open = false;  // the keyword goes on in the next line
  for (std::size_t index = 0; index < lines.size(); ++index) {
    const PlacedLine& line = lines[index];
    const std::string text = trimmed(acquisition::printable(line.text));
    if (text.empty() || text.starts_with("**")) continue;
    const bool goes_on = open && !begins_with_number(text);
    if (is_keyword_line(text)) {
      Keyword next =
          begin_keyword({text, line.where, line.number}, index, step);
      if (next.name == "STEP") step = next.step = ++steps;
      if (next.name == "ENDSTEP") step = steps + 1;
      blocks.push_back(std::move(next));
    } else if (blocks.empty()) {
      continue;
    } else if (goes_on) {
      take_options(text, blocks.back());
    } else {
      blocks.back().lines.push_back(
          {split(text), {line.where, line.number, index}, text.ends_with(',')});
    }
    open = (is_keyword_line(text) || goes_on) && text.ends_with(',');
  }
  return blocks;
}

void fail_at(const Place& place,
             const std::string& what,
             const std::string& remedy) {
  throw InputError(what, place.where, remedy);
}

std::string shortened(const std::string& text) {
  constexpr std::size_t most = 40;
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

double number_in(const DataLine& line, std::size_t field, const char* meaning) {
  std::string text = upper(line.text(field));
  std::ranges::replace(text, 'D', 'E');
  const std::optional<double> value = parsed<double>(text);
  if (!value || !std::isfinite(*value)) {
    refuse_field(line, field, meaning, "a number");
  }
  return *value;
}

double number_or(const DataLine& line,
                 std::size_t field,
                 double fallback,
                 const char* meaning) {
  return line.text(field).empty() ? fallback : number_in(line, field, meaning);
}

Eigen::Vector3d vector_in(const DataLine& line,
                          std::size_t first,
                          const char* meaning) {
  return {number_or(line, first, 0.0, meaning),
          number_or(line, first + 1, 0.0, meaning),
          number_or(line, first + 2, 0.0, meaning)};
}

std::optional<int> integer_of(const std::string& text) {
  return parsed<int>(text);
}

int integer_in(const DataLine& line, std::size_t field, const char* meaning) {
  const std::optional<int> value = integer_of(line.text(field));
  if (!value) refuse_field(line, field, meaning, "an integer");
  return *value;
}

int dof_in(const DataLine& line, std::size_t field) {
  const int dof = integer_in(line, field, "degree of freedom");
  if (dof < 1 || dof > 6) {
    fail_at(line.place,
            fmt::format("{} is no degree of freedom", dof),
            "Give one of 1 to 6.");
  }
  return dof;
}

std::string dofs_in(const DataLine& line, std::size_t field) {
  const int first = integer_in(line, field, "first degree of freedom");
  const int last = line.text(field + 1).empty()
                       ? first
                       : integer_in(line, field + 1, "last degree of freedom");
  constexpr int largest = 30;  // the last one of temperatures
  if (first < 1 || last < first || last > largest) {
    fail_at(line.place,
            fmt::format("{} to {} are no degrees of freedom", first, last),
            "Give the smaller one first, 1 to 6.");
  }
  const std::string all = "123456";
  const auto from = static_cast<std::size_t>(std::min(6, first - 1));
  return all.substr(from, static_cast<std::size_t>(last - first) + 1);
}

}  // namespace tapfit::structure
