// The files of an edited deck: which of its lines stand in each, and which file
// each of their INCLUDE lines leads to.
#pragma once

#include "updating/structure/cards/deck_source.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tapfit::structure {

/// An INCLUDE.
struct FileAsked {
  std::size_t file = 0;  ///< in the list of edited files
  std::string name;      ///< as the line says it
};

struct EditedFile {
  std::filesystem::path original;
  std::vector<std::size_t> lines;         ///< its own, in DeckSource::lines
  std::map<std::size_t, FileAsked> asks;  ///< by INCLUDE line
  bool changed = false;                   ///< one of its own lines is replaced
};

/// A file that is asked for twice is one, unless it is to say different things
/// at its places.
///
/// @param source the lines that were edited
/// @return the deck itself first; who asks stands before what is asked for
[[nodiscard]] std::vector<EditedFile> edited_files(const DeckSource& source,
                                                   const EditedDeck& edited);

/// The path from the root with links followed; itself where that is not known.
[[nodiscard]] std::filesystem::path resolved_place(
    const std::filesystem::path& file);

}  // namespace tapfit::structure
