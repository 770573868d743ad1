// The room updating/structure/abaqus. Abaqus and CalculiX decks as bulk data.
// In:  The lines of an .inp deck.
// Out: Lines of bulk data that mean the same, each with its place in the deck;
//      what is not read. All further work is done on these lines.
// May include: its row in CONTRIBUTING.md.
//
// An Abaqus or CalculiX deck translated to Nastran bulk data.
//
// Source: Abaqus Keywords Reference Guide; CalculiX CrunchiX User's Manual;
// MSC Nastran Quick Reference Guide.
#pragma once

#include "updating/structure/abaqus/keyword_block.hpp"
#include "updating/structure/abaqus/left_out.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

struct TranslatedDeck {
  std::vector<PlacedLine> lines;  ///< bulk data with its case control
  std::vector<LeftOut> left_out;  ///< without which the model lacks something
  std::vector<std::string> warnings;  ///< one sentence each
};

/// Numbers are taken as they are, in the deck's own units. Mass is consistent
/// (PARAM,COUPMASS), as CalculiX has it.
///
/// @param lines INCLUDE files inlined
/// @throws InputError with the place in the deck: an id that is taken or not
///   defined, a set, material or surface that is not defined, an element
///   without section, a number that is none, more than one part or instance
[[nodiscard]] TranslatedDeck translate_inp(
    const std::vector<PlacedLine>& lines);

}  // namespace tapfit::structure
