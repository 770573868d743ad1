#include "tui/screen/escape_sequence.hpp"

namespace tapfit::tui {
namespace {

using Next = std::function<std::optional<char32_t>()>;

// More than any terminal answers; what does not end is no sequence.
constexpr int longest = 100000;

/// Parameters and the final character, as in "1;5D".
std::u32string control_sequence(const Next& next) {
  std::u32string text;
  for (int i = 0; i < longest; ++i) {
    const std::optional<char32_t> c = next();
    if (!c) break;
    text += *c;
    if (*c >= 0x40 && *c <= 0x7E) break;
  }
  return text;
}

// As many keys as hands press within the time that a sequence takes.
constexpr std::size_t most_keys = 16;

/// Up to the string's end: BEL, or Esc and a backslash. What has no end and is
/// short was typed.
/// @return what was typed, empty for a string
std::u32string skip_string(char32_t first, const Next& next) {
  std::u32string text{first};
  bool escaped = false;
  for (int i = 0; i < longest; ++i) {
    const std::optional<char32_t> c = next();
    if (!c) return text.size() <= most_keys ? text : std::u32string();
    if (*c == 7 || (escaped && *c == U'\\')) return {};
    escaped = *c == 27;
    text += *c;
  }
  return {};
}

/// Up to the sequence that ends a paste.
void skip_paste(const Next& next) {
  std::u32string last;
  const std::u32string end = U"\033[201~";
  for (int i = 0; i < longest && last != end; ++i) {
    const std::optional<char32_t> c = next();
    if (!c) return;
    last += *c;
    if (last.size() > end.size()) last.erase(0, 1);
  }
}

std::optional<Key> key_of(const std::u32string& sequence) {
  struct Known {
    const char32_t* sequence;
    char32_t key;
  };
  static constexpr Known known[] = {{U"A", keys::up},
                                    {U"B", keys::down},
                                    {U"C", keys::right},
                                    {U"D", keys::left},
                                    {U"H", keys::home},
                                    {U"F", keys::end},
                                    {U"Z", keys::back_tab},
                                    {U"1~", keys::home},
                                    {U"7~", keys::home},
                                    {U"4~", keys::end},
                                    {U"8~", keys::end},
                                    {U"3~", keys::remove},
                                    {U"5~", keys::page_up},
                                    {U"6~", keys::page_down}};
  for (const Known& one : known) {
    if (sequence == one.sequence) return Key(one.key);
  }
  return std::nullopt;
}

}  // namespace

EscapeSequence read_escape_sequence(const Next& next) {
  const std::optional<char32_t> first = next();
  if (!first) return {};
  switch (*first) {
    case U'[': {
      const std::u32string sequence = control_sequence(next);
      if (sequence == U"200~") skip_paste(next);
      return {true, key_of(sequence), {}};
    }
    case U'O': {
      const std::optional<char32_t> last = next();
      return {true, last ? key_of({*last}) : std::nullopt, {}};
    }
    case U']':
    case U'P':
    case U'X':
    case U'^':
    case U'_': {
      const std::u32string typed = skip_string(*first, next);
      return {typed.empty(), {}, typed};
    }
    default:
      return {false, {}, {*first}};
  }
}

}  // namespace tapfit::tui
