// Changed cards of a translated Abaqus or CalculiX deck as its own keywords.
//
//   MAT1, MAT8, MAT9   *ELASTIC, *DENSITY; copies: *MATERIAL
//   PSHELL, PBEAM, ... numbers of the section; copies: *ELSET and a section
//   elements           the set that names their section; their nodes
//   SPC1               the line of *BOUNDARY
//
// Source: Abaqus Keywords Reference Guide; CalculiX CrunchiX User's Manual.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::structure {

/// The .inp with what changes and what is added, as bulk_text() of bulk data.
/// What has no keyword is said in a comment, `** not written: ...`, and so is
/// what one of the two programs passes over.
///
/// @param deck read from the .inp
/// @param added cards in free field and comments
/// @throws InputError as read_bulk_data()
[[nodiscard]] EditedDeck keyword_text(const Deck& deck,
                                      const CardChanges& changes,
                                      const std::vector<std::string>& added);

}  // namespace tapfit::structure
