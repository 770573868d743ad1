// The room updating/structure/cards. Bulk data as text: lines, cards, fields,
// numbers.
// In:  The files of a deck.
// Out: Cards with their place in the file. What they mean is decided in
//      updating/structure/readers.
// May include: its row in CONTRIBUTING.md.
//
// Nastran bulk data as cards: lines are put into fields (free, small and large
// field), continuations joined, INCLUDE files brought in. What the fields mean
// is not known here.
//
// Source: MSC Nastran Quick Reference Guide, "Format of bulk data entries".
#pragma once

#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/card.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::structure {

struct BulkData {
  std::vector<std::string> lines;  ///< the whole file, INCLUDE files inlined
  std::vector<Card> cards;
  CaseControl control;
  /// Of an Abaqus or CalculiX deck, see DeckLines.
  std::vector<LeftOut> left_out;
  std::vector<std::string> warnings;
};

/// Reads a deck up to ENDDATA. A file without BEGIN BULK is all bulk data,
/// apart from lines that look like executive or case control.
///
/// @throws InputError for a file that cannot be read, a continuation that
///   follows nothing, a line with too many fields, an INCLUDE that goes round,
///   a repetition of nothing
[[nodiscard]] BulkData read_bulk_data(const std::filesystem::path& path);

/// The cards that lines of bulk data make, comments left out.
/// @throws InputError as read_bulk_data()
[[nodiscard]] std::vector<Card> cards_in(const std::vector<std::string>& lines);

}  // namespace tapfit::structure
