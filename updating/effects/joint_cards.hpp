// A joint in bulk data: the elements on one side of the line take doubles of
// its grids, which follow them in all but the turn about the line, and a spring
// between the two turns.
//
//   about an axis of the deck   GRID d; RBE2 g -> d but for component c;
//                               CELAS2 k l between d and g in c
//   about any other             CORD2R with its z axis there; hinge grids a and
//                               b of its axes; RBE2 g -> a; RBE2 a -> b but for
//                               6; RBE2 b -> d; CELAS2 k l between b and a in 6
//   a crack                     GRID d; CELAS2 between d and g in each
//   component
//                               of a face along axes of the deck
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/crack_line.hpp"
#include "updating/places/joint_line.hpp"
#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

#include <map>
#include <string>
#include <vector>

namespace tapfit::effects {

/// 1..3: the direction across which a joint's bar turns, the one mostly
/// measured or, where the bar lies along it, another.
[[nodiscard]] int turned_across(const updating::Location& where,
                                const TestContext& context);

/// The line that a joint's place means.
[[nodiscard]] updating::JointLine joint_at(const updating::Location& where,
                                           const TestContext& context);

struct JointCards {
  std::vector<std::string> added;
  std::map<int, int>
      doubles;  ///< grid -> the one that the side's elements take
  std::vector<int> side = {};
};

/// @param stiffness k per metre of the line, or of the bar's end [N m/rad per m
///   or N m/rad]
/// @return no doubles, and a comment, where a grid has displacement axes (CD)
/// of
///   its own: what they mean to the elements there a double would have to share
[[nodiscard]] JointCards joint_cards(const structure::Deck& deck,
                                     const updating::JointLine& joint,
                                     double stiffness);

/// @param stiffness k per area of the faces [N/m^3]
/// @return as of a joint; without springs, and with a comment, where the faces
///   are along no axes of the deck
[[nodiscard]] JointCards crack_cards(const structure::Deck& deck,
                                     const updating::CrackLine& crack,
                                     double stiffness);

/// Of a joint's place, whichever form it has.
[[nodiscard]] JointCards joint_cards(const updating::Location& where,
                                     const TestContext& context,
                                     double stiffness);

}  // namespace tapfit::effects
