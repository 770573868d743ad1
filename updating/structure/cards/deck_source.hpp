// A deck's files as one text, INCLUDE files brought in at their place, and
// where each of its lines stands.
#pragma once

#include "updating/structure/abaqus/keyword_block.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::structure {

/// Of the deck as a whole: some five million cards.
inline constexpr std::uintmax_t max_deck_bytes = 512U << 20U;

/// A file of the deck; one that is asked for twice is two.
struct DeckFile {
  std::filesystem::path path;
  std::string name;          ///< as INCLUDE says it; of the deck itself empty
  std::size_t asked_at = 0;  ///< the INCLUDE, in DeckSource::lines
};

/// Where a line stands.
struct LineOrigin {
  std::uint32_t file = 0;  ///< in DeckSource::files
  int first = 0;           ///< number of its first line in the file
  int count = 1;           ///< above 1: an INCLUDE whose name goes on
};

struct DeckSource {
  /// An INCLUDE is a comment above what it brings in.
  std::vector<PlacedLine> lines;
  std::vector<LineOrigin> origins;  ///< one for each line
  std::vector<DeckFile> files;      ///< the deck itself, then by lines
  bool keywords = false;            ///< an Abaqus or CalculiX deck
};

/// @throws InputError for a file that cannot be read, is no deck, or includes
///   itself, and for more than 1000 INCLUDE files or max_deck_bytes
[[nodiscard]] DeckSource read_deck_source(const std::filesystem::path& path);

/// Without the mark of UTF-8 with which editors may begin a file.
void drop_byte_order_mark(std::string& text);

}  // namespace tapfit::structure
