// The SHA-256 digest of a text or file: what anyone can check without this
// program (sha256sum FILE).
#pragma once

#include <string>
#include <string_view>

namespace tapfit::acquisition {

/// @return 64 hexadecimal digits
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace tapfit::acquisition
