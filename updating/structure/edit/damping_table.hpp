// Measured damping as a table that Nastran's responses can take.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::structure {

/// The next number that no table of the deck has: they share them.
/// @throws InputError as read_bulk_data()
[[nodiscard]] int free_table(const std::filesystem::path& deck);

/// TABDMP1 of type CRIT, with a comment on how it is taken (SDAMPING). Beyond
/// the first and last frequency, where Nastran goes on along a straight line,
/// the damping stays as it is there.
///
/// @param id of no other table, as free_table()
/// @param damping frequency [Hz] and ratio of critical, ascending
/// @return lines of bulk data; none without damping
[[nodiscard]] std::vector<std::string> damping_table_cards(
    int id, const std::vector<std::array<double, 2>>& damping);

/// The same as comments, for decks of keywords: *MODAL DAMPING stands in steps.
[[nodiscard]] std::vector<std::string> damping_comments(
    const std::vector<std::array<double, 2>>& damping);

}  // namespace tapfit::structure
