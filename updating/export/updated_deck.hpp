// The room updating/export. What leaves the program for other programs: the
// updated deck, universal files.
// In:  A session.
// Out: Files.
// May include: its row in CONTRIBUTING.md.
//
// The deck of a session's model: the original lines with the identified base
// properties in their cards, and the cards of the effects added.
#pragma once

#include "updating/export/written_deck.hpp"
#include "updating/session/session.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::updating {

/// Cards of the effects, each with element ids of its own.
///
/// @param added_effects with the values that all of them together have
[[nodiscard]] std::vector<std::string> effect_cards(
    const std::vector<Candidate>& added_effects,
    const acquisition::TestBundle& bundle,
    const structure::Deck& deck);

/// @param added_effects with the values that all of them together have
/// @param identified uncertain properties
/// @param form what the deck leaves out, put on its cards
/// @throws InputError for a deck that cannot be read again
[[nodiscard]] UpdatedDeck updated_deck(
    const acquisition::TestBundle& bundle,
    const structure::Deck& deck,
    const std::vector<Candidate>& added_effects,
    const std::vector<Estimate>& identified,
    const std::vector<ModelForm>& form = {});

/// The updated deck, with the measured damping as a table (TABDMP1), or as
/// comments where it is keywords. Of a deck with INCLUDE files those in which
/// cards change are written beside it, the others stay where they are.
///
/// @throws InputError for a bundle without a deck, a file that cannot be
///   written; Stopped
WrittenDeck write_updated_deck(Session& session,
                               const std::filesystem::path& path,
                               const acquisition::OutputRule& rule,
                               const Progress& progress);

/// @throws InputError for .inp where the deck is bulk data, which would be read
///   as another kind of deck; for a folder, a pipe or a device
void check_deck_name(const acquisition::TestBundle& bundle,
                     const std::filesystem::path& path);

/// @throws InputError for a model given as matrices, which has no deck
void check_has_deck(const Session& session);

}  // namespace tapfit::updating
