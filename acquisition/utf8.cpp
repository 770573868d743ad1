#include "acquisition/utf8.hpp"

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

}  // namespace

std::string as_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::string result;
  for (const char byte : text) {
    const auto value = static_cast<unsigned char>(byte);
    if (value < 0x80) {
      result += byte;
    } else {
      result += static_cast<char>(0xc0 | value >> 6);
      result += static_cast<char>(0x80 | (value & 0x3f));
    }
  }
  return result;
}

}  // namespace tapfit::acquisition
