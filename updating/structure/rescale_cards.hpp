// Numbers of a deck's own cards multiplied, everything else left as written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::structure {

/// Fields of one card that are multiplied; fields left blank stay blank.
struct CardScale {
  std::string name;  ///< "MAT1"
  int id = 0;        ///< first data field
  /// Positions as in Card::fields: 1 is the id.
  std::vector<std::size_t> fields;
  double factor = 1.0;
};

struct RescaledDeck {
  /// INCLUDE files inlined. The old lines of a changed card stay as comments,
  /// its new ones follow in large field.
  std::vector<std::string> lines;
  std::vector<bool> done;  ///< per scale: whether a number was changed
};

/// @throws InputError for a deck that cannot be read
[[nodiscard]] RescaledDeck rescale_cards(const std::filesystem::path& deck,
                                         const std::vector<CardScale>& scales);

}  // namespace tapfit::structure
