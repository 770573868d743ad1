#include "tui/screen/key.hpp"

#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace tapfit::tui {
namespace {

using Named = std::pair<std::string_view, char32_t>;

constexpr std::array<Named, 17> names{{
    {"Enter", keys::enter},
    {"Esc", keys::escape},
    {"Tab", keys::tab},
    {"S-Tab", keys::back_tab},
    {"BS", keys::backspace},
    {"Up", keys::up},
    {"Down", keys::down},
    {"Left", keys::left},
    {"Right", keys::right},
    {"Home", keys::home},
    {"End", keys::end},
    {"PageUp", keys::page_up},
    {"PageDown", keys::page_down},
    {"Del", keys::remove},
    {"Space", U' '},
    {"lt", U'<'},
    {"WheelDown", keys::wheel_down},
}};

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) {
    return std::tolower(static_cast<unsigned char>(p)) ==
           std::tolower(static_cast<unsigned char>(q));
  });
}

std::optional<Key> key_of_name(std::string_view word) {
  for (const auto& [text, code] : names) {
    if (same_word(text, word)) return Key(code);
  }
  if (word.size() == 3 && same_word(word.substr(0, 2), "C-")) {
    const int letter = std::tolower(static_cast<unsigned char>(word[2]));
    return Key(static_cast<char32_t>(letter), true);
  }
  return std::nullopt;
}

}  // namespace

std::optional<NamedKey> read_key(std::string_view text) {
  if (text.empty()) return std::nullopt;
  if (text[0] != '<') {
    std::size_t bytes = 1;
    while (bytes < text.size() &&
           (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) {
      ++bytes;
    }
    return NamedKey{Key(decode(text.substr(0, bytes)).at(0).base), bytes};
  }
  const std::size_t close = text.find('>');
  if (close == std::string_view::npos) return std::nullopt;
  const std::optional<Key> key = key_of_name(text.substr(1, close - 1));
  if (!key) return std::nullopt;
  return NamedKey{*key, close + 1};
}

std::string name(const Key& key) {
  std::string text;
  if (key.ctrl) {
    text = "<C-";
    append_utf8(text, key.code);
    return text + ">";
  }
  for (const auto& [word, code] : names) {
    if (code == key.code) return fmt::format("<{}>", word);
  }
  append_utf8(text, key.code);
  return text;
}

std::string key_label(const Key& key) {
  if (key.ctrl) {
    const auto letter = static_cast<unsigned char>(key.code);
    return fmt::format("^{:c}", std::toupper(letter));
  }
  const std::string named = name(key);
  return named.size() > 2 && named.front() == '<'
             ? named.substr(1, named.size() - 2)
             : named;
}

}  // namespace tapfit::tui
