// The SHA-256 digest of a text or file: what anyone can check without this
// program (sha256sum FILE).
//
// Source: NIST, FIPS 180-4, "Secure Hash Standard", 2015, sections 4, 5
// and 6.2.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::acquisition {

/// @return 64 hexadecimal digits
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace tapfit::acquisition
