#include "updating/structure/abaqus/keyword_shapes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/keyword_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>

namespace tapfit::structure {
namespace {

bool is_numeric(const std::string& field) {
  return std::ranges::all_of(field, [](unsigned char c) {
    return std::isdigit(c) != 0 ||
           std::string_view("+-.eEdD").find(static_cast<char>(c)) !=
               std::string_view::npos;
  });
}

// Names hold letters, digits and a few signs.
bool is_simple(const std::string& field) {
  constexpr std::size_t longest = 80;
  return field.size() <= longest &&
         std::ranges::all_of(field, [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' ||
                  c == '+' || c == '"';
         });
}

bool is_data(const std::string& text) {
  const bool commas = text.find(',') != std::string::npos;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::string field = trimmed(text.substr(from, comma - from));
    if (!(commas ? is_simple(field) : is_numeric(field))) return false;
    from = comma + 1;
  }
  return true;
}

bool next_of(std::istream& file, std::string& text) {
  constexpr std::size_t longest = 1U << 20U;
  return acquisition::take_line(file, text) && text.size() < longest;
}

}  // namespace

void KeywordShapes::add(const std::string& written) {
  const std::string text = trimmed(written);
  if (text.empty() || text.starts_with("**")) return;
  if (is_keyword_line(text)) {
    in_heading_ = upper(text).starts_with("*HEADING");
    ++fitting_;
  } else if (!in_heading_) {
    ++(is_data(text) ? fitting_ : others_);
  }
}

void KeywordShapes::check(const std::filesystem::path& path,
                          const std::string& asked_by) const {
  if (others_ <= fitting_) return;
  throw InputError(
      fmt::format("{} is no Abaqus or CalculiX deck: {} of its {} lines are "
                  "neither keywords nor data",
                  path.string(),
                  others_,
                  others_ + fitting_),
      asked_by,
      "Name a deck of keywords (*NODE, *ELEMENT, ...) and data lines.");
}

bool is_keyword_deck(const std::filesystem::path& path) {
  std::ifstream file = acquisition::open_input(path);
  const bool named = upper(path.extension().string()) == ".INP";
  std::string text;
  for (bool first = true; next_of(file, text); first = false) {
    if (first && text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    const std::string line = trimmed(text);
    if (line.empty() || line.starts_with("**")) continue;
    if (is_keyword_line(line)) return true;
    if (!named) return false;
  }
  return false;
}

}  // namespace tapfit::structure
