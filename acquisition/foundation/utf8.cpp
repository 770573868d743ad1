#include "acquisition/foundation/utf8.hpp"

#include <algorithm>

namespace tapfit::acquisition {
namespace {

// Bytes that follow a leading one; -1 where it leads nothing.
int followers(unsigned char lead) {
  if (lead < 0x80) return 0;
  if (lead >= 0xc2 && lead < 0xe0) return 1;
  if (lead >= 0xe0 && lead < 0xf0) return 2;
  if (lead >= 0xf0 && lead < 0xf5) return 3;
  return -1;
}

bool is_utf8(std::string_view text) {
  int wanted = 0;
  for (const char byte : text) {
    const auto value = static_cast<unsigned char>(byte);
    if (wanted > 0 && (value & 0xc0) == 0x80) {
      --wanted;
    } else if (wanted == 0 && followers(value) >= 0) {
      wanted = followers(value);
    } else {
      return false;
    }
  }
  return wanted == 0;
}

void append_latin1(unsigned char value, std::string& text) {
  text += static_cast<char>(0xc0 | value >> 6);
  text += static_cast<char>(0x80 | (value & 0x3f));
}

bool is_plain(char c) {
  return (c >= ' ' && c <= '~') || c == '\n' || c == '\t';
}

// Of one byte, which may be of Latin-1, or of several that are UTF-8.
char32_t code_point(std::string_view sequence) {
  const auto lead = static_cast<unsigned char>(sequence.front());
  if (sequence.size() == 1) return lead;
  char32_t code = lead & (0x7fU >> sequence.size());
  for (const char byte : sequence.substr(1)) {
    code = code << 6U | (static_cast<unsigned char>(byte) & 0x3fU);
  }
  return code;
}

// Those of ASCII but line end and tab, U+0080 to U+009F, the ends of lines and
// paragraphs of Unicode, and what turns the direction of writing, so that a
// text reads as another.
bool is_control(char32_t code) {
  return (code < 0x20 && code != U'\n' && code != U'\t') ||
         (code >= 0x7f && code < 0xa0) || code == 0x061c || code == 0x200e ||
         code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string printable(std::string_view text) {
  if (std::ranges::all_of(text, is_plain)) return std::string(text);
  std::string result;
  while (!text.empty()) {
    const auto lead = static_cast<unsigned char>(text.front());
    const auto length = static_cast<std::size_t>(1 + followers(lead));
    const bool whole = length > 0 && is_utf8(text.substr(0, length));
    const std::string_view sequence = text.substr(0, whole ? length : 1);
    if (is_control(code_point(sequence))) {
      result += '?';
    } else if (whole) {
      result += sequence;
    } else {
      append_latin1(lead, result);
    }
    text.remove_prefix(sequence.size());
  }
  return result;
}

std::string as_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::string result;
  for (const char byte : text) {
    const auto value = static_cast<unsigned char>(byte);
    if (value < 0x80) {
      result += byte;
    } else {
      append_latin1(value, result);
    }
  }
  return result;
}

}  // namespace tapfit::acquisition
