// A document as one HTML file that needs nothing beside it.
#pragma once

#include "tui/document/document.hpp"

#include <string>

namespace tapfit::tui {

/// HTML with its style and pictures inside; nothing is fetched. Readable from a
/// phone's width up, and printed on A4 with a page of its own for every section
/// that asks for one. Animated pictures are printed at rest.
[[nodiscard]] std::string as_html(const Document& document);

}  // namespace tapfit::tui
