// Names out of older files, which are written in Latin-1.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::acquisition {

/// The text in UTF-8: as it is where it is that already, else read as Latin-1.
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace tapfit::acquisition
