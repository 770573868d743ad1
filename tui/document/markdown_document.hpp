// A document as Markdown, its pictures in files of their own.
#pragma once

#include "tui/document/document.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// @param folder of the pictures, as it is written in the text
[[nodiscard]] std::string as_markdown(const Document& document,
                                      const std::string& folder);

/// The document's pictures in their order; each a file NAME.svg.
[[nodiscard]] std::vector<Figure> figures_of(const Document& document);

}  // namespace tapfit::tui
