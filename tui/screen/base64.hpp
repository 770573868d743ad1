// Bytes as letters, for what terminals are sent.
//
// Source: RFC 4648, section 4.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::tui {

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace tapfit::tui
