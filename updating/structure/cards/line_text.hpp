// One line of a deck as text.
#pragma once

#include "acquisition/foundation/trimmed_text.hpp"

#include <string>

namespace tapfit::structure {

/// Tabs lead to the next column that is a multiple of 8.
[[nodiscard]] std::string expand_tabs(const std::string& text);

/// Up to the first $. A quote may hold one only in file names, which INCLUDE
/// reads beforehand.
[[nodiscard]] std::string without_comment(const std::string& text);

[[nodiscard]] bool is_begin_bulk(const std::string& text);
[[nodiscard]] bool is_end(const std::string& text);

/// Whether a line of a file without BEGIN BULK is executive or case control: a
/// word of those, or NAME = value.
[[nodiscard]] bool looks_like_control(const std::string& text);

}  // namespace tapfit::structure
