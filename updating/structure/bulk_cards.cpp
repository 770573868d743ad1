#include "updating/structure/bulk_cards.hpp"

#include "acquisition/input_error.hpp"
#include "updating/structure/bulk_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace tapfit::structure {
namespace {

constexpr std::size_t kDataFields = 8;

struct Fields {
  std::string name;               // first field as written
  std::vector<std::string> data;  // exactly 8, or 4 for large field
  std::string marker;             // tenth field
};

Fields split_free(const std::string& text, const std::string& where) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  while (true) {
    const std::size_t comma = text.find(',', from);
    parts.push_back(trimmed(text.substr(from, comma - from)));
    if (comma == std::string::npos) break;
    from = comma + 1;
  }
  Fields fields;
  fields.name = parts.front();
  const bool large = fields.name.find('*') != std::string::npos;
  const std::size_t width = large ? kDataFields / 2 : kDataFields;
  while (parts.size() > width + 2 && parts.back().empty()) parts.pop_back();
  if (parts.size() > width + 2) {
    throw InputError(
        fmt::format(
            "the line has {} fields, {} are the most", parts.size(), width + 2),
        where,
        "Split the entry into a first line and continuation lines.");
  }
  parts.resize(width + 2);
  fields.data.assign(parts.begin() + 1, parts.end() - 1);
  fields.marker = parts.back();
  return fields;
}

Fields split_fixed(std::string text) {
  text.resize(std::max<std::size_t>(text.size(), 80), ' ');
  Fields fields;
  fields.name = trimmed(text.substr(0, 8));
  const bool large = fields.name.find('*') != std::string::npos;
  const std::size_t width = large ? 16 : 8;
  for (std::size_t at = 8; at < 72; at += width) {
    fields.data.push_back(trimmed(text.substr(at, width)));
  }
  fields.marker = trimmed(text.substr(72, 8));
  return fields;
}

bool is_continuation(const std::string& name) {
  return name.empty() || name.front() == '+' || name.front() == '*';
}

// The first character of a marker is its own (+, * or anything).
bool markers_differ(const std::string& before, const std::string& name) {
  return before.size() > 1 && name.size() > 1 &&
         before.substr(1) != name.substr(1);
}

void append_line(const SourceLine& line,
                 std::vector<Card>& cards,
                 std::string& marker) {
  const Fields fields = line.text.find(',') != std::string::npos
                            ? split_free(line.text, line.where)
                            : split_fixed(line.text);
  if (is_continuation(fields.name)) {
    if (cards.empty() || markers_differ(marker, fields.name)) {
      throw InputError(
          fmt::format("the continuation \"{}\" follows no entry that asks "
                      "for it",
                      fields.name),
          line.where,
          "Put continuation lines directly below the line they continue.");
    }
  } else {
    std::string name = upper(fields.name);
    std::erase(name, '*');
    Card card;
    card.fields.push_back(trimmed(name));
    card.where = line.where;
    card.line = line.number;
    card.first = line.index;
    cards.push_back(card);
  }
  cards.back().last = line.index;
  std::vector<std::string>& all = cards.back().fields;
  all.insert(all.end(), fields.data.begin(), fields.data.end());
  marker = fields.marker;
}

}  // namespace

BulkData read_bulk_data(const std::filesystem::path& path) {
  const DeckLines source = read_deck_lines(path);
  BulkData result;
  result.lines = source.all;
  result.spc_set = source.spc_set;
  std::string marker;
  for (const SourceLine& line : source.bulk) {
    append_line(line, result.cards, marker);
  }
  return result;
}

std::optional<double> parse_real(const std::string& text) {
  std::string number;
  for (const char raw : text) {
    const char c = (raw == 'd' || raw == 'D' || raw == 'e') ? 'E' : raw;
    const bool sign = c == '+' || c == '-';
    if (sign && !number.empty() && number.back() != 'E') number += 'E';
    if (c == '+' && (number.empty() || number.back() == 'E')) continue;
    number += c;
  }
  double value = 0.0;
  const char* end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<int> parse_integer(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  int value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || begin == end) return std::nullopt;
  return value;
}

}  // namespace tapfit::structure
