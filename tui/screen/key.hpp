// Keys and mouse events, and their names: "a", "<Enter>", "<C-r>".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tapfit::tui {

struct Key {
  char32_t code = 0;  ///< a character, or one of `keys` below
  bool ctrl = false;
  int x = -1;  ///< cell of a mouse event
  int y = -1;

  constexpr Key() = default;
  constexpr Key(char32_t character)  // NOLINT: a character is a key
      : code(character) {}
  constexpr Key(char32_t character, bool with_ctrl)
      : code(character), ctrl(with_ctrl) {}

  constexpr bool operator==(const Key& other) const {
    return code == other.code && ctrl == other.ctrl;
  }
};

/// Keys that are no characters, in Unicode's private area.
namespace keys {
inline constexpr char32_t enter = 0xE000;
inline constexpr char32_t escape = 0xE001;
inline constexpr char32_t tab = 0xE002;
inline constexpr char32_t back_tab = 0xE003;
inline constexpr char32_t backspace = 0xE004;
inline constexpr char32_t up = 0xE005;
inline constexpr char32_t down = 0xE006;
inline constexpr char32_t left = 0xE007;
inline constexpr char32_t right = 0xE008;
inline constexpr char32_t home = 0xE009;
inline constexpr char32_t end = 0xE00A;
inline constexpr char32_t page_up = 0xE00B;
inline constexpr char32_t page_down = 0xE00C;
inline constexpr char32_t remove = 0xE00D;
inline constexpr char32_t click = 0xE010;
inline constexpr char32_t wheel_up = 0xE011;
inline constexpr char32_t wheel_down = 0xE012;
inline constexpr char32_t resize = 0xE013;
inline constexpr char32_t release = 0xE014;  ///< of the button that clicked
}  // namespace keys

/// The key that the text names, and how many bytes that took: the first
/// character, or a name in angle brackets ("<lt>" is '<' itself).
struct NamedKey {
  Key key;
  std::size_t bytes = 0;
};

/// @return empty for no text, and for "<…>" that names no key
[[nodiscard]] std::optional<NamedKey> read_key(std::string_view text);

/// read_key's inverse.
[[nodiscard]] std::string name(const Key& key);

/// As the key bar and the help have it: "^R", "Space", "u".
[[nodiscard]] std::string key_label(const Key& key);

}  // namespace tapfit::tui
