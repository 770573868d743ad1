#include "updating/structure/cards/card_shapes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/line_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace tapfit::structure {
namespace {

// `=` repeats the card above.
bool continues_card(const std::string& text) {
  return std::string_view(" +*,=").find(text.front()) != std::string_view::npos;
}

// Characters of the name at the beginning; 0 where there is none.
std::size_t name_length(const std::string& text) {
  std::size_t length = 0;
  while (length < text.size() &&
         std::isalnum(static_cast<unsigned char>(text[length])) != 0) {
    ++length;
  }
  constexpr std::size_t longest = 8;
  const bool named = length <= longest &&
                     std::isalpha(static_cast<unsigned char>(text[0])) != 0;
  return named ? length : 0;
}

bool is_card(const std::string& text) {
  const std::size_t name = name_length(text);
  if (name == 0) return false;
  const bool large = name < text.size() && text[name] == '*';
  const std::size_t after = name + (large ? 1 : 0);
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos) {
    return trimmed(text.substr(after, comma - after)).empty();
  }
  constexpr std::size_t first = 8;
  constexpr std::size_t last = 72;
  if (after > first || !trimmed(text.substr(after, first - after)).empty()) {
    return false;
  }
  const std::size_t width = large ? 16 : 8;
  bool any = false;
  for (std::size_t at = first; at < std::min(text.size(), last); at += width) {
    const std::string field = trimmed(text.substr(at, width));
    if (field.find(' ') != std::string::npos) return false;
    any = any || !field.empty();
  }
  return any;
}

}  // namespace

void CardShapes::add(const std::string& written) {
  const std::string text = expand_tabs(without_comment(written));
  if (ended_ || trimmed(text).empty()) return;
  if (is_begin_bulk(text)) {
    // What stands above it was no bulk data, and need not be.
    cards_ = others_ = 0;
  } else if (is_end(text)) {
    ended_ = true;
  } else if (!looks_like_control(text) && !continues_card(text)) {
    ++(is_card(text) ? cards_ : others_);
  }
}

void CardShapes::check(const std::filesystem::path& path,
                       const std::string& asked_by) const {
  if (others_ <= cards_) return;
  throw InputError(
      fmt::format("{} is no Nastran bulk data: {} of its {} lines are no cards",
                  path.string(),
                  others_,
                  others_ + cards_),
      asked_by,
      "Name a file of bulk data, in free, small or large field format.");
}

}  // namespace tapfit::structure
