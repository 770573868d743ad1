#include "updating/structure/edit/keyword_names.hpp"

#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

constexpr std::string_view prefix = "TAPFIT_";

// The largest number behind the prefix in a line.
int number_in_names(const std::string& line) {
  const std::string text = upper(line);
  int largest = 0;
  std::size_t at = text.find(prefix);
  while (at != std::string::npos) {
    at += prefix.size();
    const std::size_t end =
        std::min(text.find_first_not_of("0123456789", at), text.size());
    const auto number = parse_integer(text.substr(at, end - at));
    largest = std::max(largest, number.value_or(0));
    at = text.find(prefix, end);
  }
  return largest;
}

}  // namespace

KeywordNames::KeywordNames(const KeywordDeck& deck) {
  for (const std::string& line : deck.lines) {
    last_ = std::max(last_, number_in_names(line));
  }
  // As the assembly is joined with its part when it is read.
  std::vector<int> own;
  bool in_assembly = false;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.name == "ASSEMBLY") in_assembly = true;
    if (keyword.name == "ENDASSEMBLY") in_assembly = false;
    if (keyword.name == "INSTANCE") instance_ = keyword.options.at("NAME");
    if (keyword.name != "NODE") continue;
    for (const DataLine& line : keyword.lines) {
      const int id = integer_of(line.text(0)).value_or(0);
      raised_by_ = std::max(raised_by_, id);
      if (in_assembly) own.push_back(id);
    }
  }
  for (const int id : own) of_assembly_.insert(id + raised_by_);
}

std::string KeywordNames::next() {
  return fmt::format("{}{}", prefix, ++last_);
}

std::string KeywordNames::node(int id) const {
  if (instance_.empty()) return std::to_string(id);
  if (of_assembly_.contains(id)) return std::to_string(id - raised_by_);
  return fmt::format("{}.{}", instance_, id);
}

std::vector<std::string> element_set(const std::string& name,
                                     const std::vector<int>& elements) {
  constexpr std::size_t per_line = 16;
  std::vector<std::string> lines = {"*ELSET, ELSET=" + name};
  for (std::size_t k = 0; k < elements.size(); k += per_line) {
    const std::size_t end = std::min(k + per_line, elements.size());
    lines.push_back(
        fmt::format("{}",
                    fmt::join(elements.begin() + static_cast<long>(k),
                              elements.begin() + static_cast<long>(end),
                              ", ")));
  }
  return lines;
}

std::vector<std::string> boundary_lines(const std::string& node,
                                        const std::string& components) {
  std::vector<std::string> lines;
  std::string sorted = components;
  std::ranges::sort(sorted);
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const char first = sorted[k];
    while (k + 1 < sorted.size() && sorted[k + 1] == sorted[k] + 1) ++k;
    lines.push_back(fmt::format("{}, {}, {}", node, first, sorted[k]));
  }
  return lines;
}

}  // namespace tapfit::structure
