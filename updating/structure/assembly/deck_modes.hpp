// Modes of a deck, with what a mechanism is told by: where it moves.
//
// Motions without stiffness beyond those of a rigid body on its supports,
//
//   phi' K phi = 0,  phi not in span(R),  R the rigid motions that the
//   constraints allow,
//
// come from grids or parts that are not joined.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace tapfit::structure {

struct DeckModes {
  Eigenmodes modes;                   ///< over the free entries of q
  std::vector<std::string> warnings;  ///< held motions, mechanisms
};

/// The lowest modes of a deck.
///
/// @param system assembled from the deck
/// @throws InputError naming a grid that moves without stiffness or mass, or
///   when the solver does not converge
[[nodiscard]] DeckModes deck_modes(const Deck& deck,
                                   const System& system,
                                   Eigen::Index count,
                                   const std::stop_token& stop = {});

/// Motions that are held for want of stiffness, and mechanisms among modes of a
/// deck that were solved for otherwise, as DeckModes::warnings.
///
/// @param phi free degrees of freedom x modes, unit modal mass
[[nodiscard]] std::vector<std::string> mechanism_warnings(
    const Deck& deck, const System& system, const Eigen::MatrixXd& phi);

/// Throws the error of deck_modes() where a grid of the deck moves without
/// stiffness or mass; for a deck that was found singular after splitting it,
/// whose new grids nobody knows.
void name_mechanism(const Deck& deck);

}  // namespace tapfit::structure
