// The lines of a deck: comments and executive control set aside, INCLUDE files
// brought in at their place, Abaqus and CalculiX decks translated.
#pragma once

#include "updating/structure/abaqus/left_out.hpp"
#include "updating/structure/cards/case_control.hpp"
#include "updating/structure/cards/line_text.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

struct SourceLine {
  std::string text;   ///< comment removed, tabs expanded, not blank
  std::string where;  ///< "file:line"
  int number = 0;
  std::size_t index = 0;  ///< in DeckLines::all
};

struct DeckLines {
  std::vector<std::string> all;  ///< every line as written, INCLUDE inlined
  std::vector<SourceLine> bulk;  ///< between BEGIN BULK and ENDDATA
  CaseControl control;
  /// Of an Abaqus or CalculiX deck, whose lines are those of its translation.
  std::vector<LeftOut> left_out;
  std::vector<std::string> warnings;
};

/// A deck that begins with a keyword (`*NODE`) is an Abaqus or CalculiX one.
///
/// @throws InputError for a file that cannot be read, is no deck, or includes
///   itself, and for more than 1000 INCLUDE files or 512 MB
[[nodiscard]] DeckLines read_deck_lines(const std::filesystem::path& path);

/// Which files of a deck are opened; all, where it is empty.
using MayOpen = std::function<bool(const std::filesystem::path&)>;

/// The deck and all that it includes, each once, also where the deck cannot be
/// read as a whole: files that are not there, and those that may not be opened,
/// are named, too.
[[nodiscard]] std::vector<std::filesystem::path> deck_files(
    const std::filesystem::path& path, const MayOpen& may_open = {});

}  // namespace tapfit::structure
