// Cards that are added to an Abaqus or CalculiX deck as its keywords.
//
//   GRID      *NODE, and *BOUNDARY for what it is held in
//   CONM2     *MASS
//   CELAS2    *SPRING of SPRING1, SPRING2
//   CDAMP2    *DASHPOT of DASHPOTA, the one kind of CalculiX: to a node of its
//             own along the component
//   RBE2      *KINEMATIC COUPLING
//   SPC1      *BOUNDARY
//
// What Abaqus alone takes is written and said where the model needs it (springs
// on rotations, which CalculiX 2.20 passes over, and the coupling); rotary
// inertia and dampers on rotations, at which it stops, are put as comments.
//
// Source: Abaqus Keywords Reference Guide; CalculiX CrunchiX User's Manual.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/keyword_names.hpp"

#include <set>
#include <string>
#include <vector>

namespace tapfit::structure {

/// A comment ("$ text"), or a card.
struct AddedCard {
  std::string comment;
  Card card;
};

/// @param added comments and cards in free field, continuations behind them
[[nodiscard]] std::vector<AddedCard> added_cards(
    const std::vector<std::string>& added);

/// New grids along axes of their own (CD), which have no keyword, and those
/// that follow them.
[[nodiscard]] std::set<int> grids_left_out(const std::vector<AddedCard>& cards);

struct AddedKeywords {
  std::vector<std::string> of_part;   ///< nodes, elements
  std::vector<std::string> of_model;  ///< what stands outside a part
};

/// @param deck that they are added to
/// @param left_out grids whose cards are not written
[[nodiscard]] AddedKeywords keyword_lines(const Deck& deck,
                                          const std::vector<AddedCard>& cards,
                                          const std::set<int>& left_out,
                                          KeywordNames& names);

}  // namespace tapfit::structure
