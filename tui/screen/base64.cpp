#include "tui/screen/base64.hpp"

namespace tapfit::tui {

/// Three bytes become four letters of six bits each.
std::string base64(std::string_view bytes) {
  static constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = i + k;
      bits = bits << 8U;
      if (at < bytes.size()) bits |= static_cast<unsigned char>(bytes[at]);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool holds = i + k <= bytes.size();
      text += holds ? letters[bits >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace tapfit::tui
