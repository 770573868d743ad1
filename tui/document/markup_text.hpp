// Text inside HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::tui {

/// & < > " ' as entities, line ends and tabs as spaces, and nothing that is not
/// printable: what acquisition::printable makes of it.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace tapfit::tui
