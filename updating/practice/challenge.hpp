// Draws what a challenge hides: a practice case for people, easy or hard.
//
// Easy: one effect of a kind that is told well, large, little noise, and a deck
// that is right in all else. Hard: none, one or two effects of any kind of the
// catalogue, down to a twelfth of the size that practice cases have, more
// noise, and a modulus that is off by about as much as the deck's owner thinks
// possible, or more.
#pragma once

#include "updating/virtual_test/virtual_spec.hpp"

#include <cstdint>
#include <string>

namespace tapfit::updating {

enum class ChallengeLevel { Easy, Hard };

/// The same for the same seed.
/// @param structure one of virtual_structures(); empty: drawn
/// @return to be sealed
[[nodiscard]] VirtualBundleSpec draw_challenge(
    ChallengeLevel level,
    std::uint64_t seed,
    const std::string& structure = {});

/// An effect made smaller or larger: what is added in proportion; what gives
/// way by its compliance; what is lost, and what a gain is off by.
/// @param share of its size; 0 would be nothing. A remaining stiffness stays
///   above zero only for shares up to 1
[[nodiscard]] VirtualEffect resized(VirtualEffect effect, double share);

}  // namespace tapfit::updating
