// An Abaqus or CalculiX deck as it was written, and where in it the cards of
// its translation come from.
#pragma once

#include "updating/structure/abaqus/keyword_block.hpp"
#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/edit/field_line.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tapfit::structure {

/// Lines of keywords that may be changed, by their place in the deck.
using KeywordText = std::map<std::size_t, FieldLine>;

struct KeywordDeck {
  std::vector<std::string> lines;  ///< INCLUDE files inlined
  std::vector<Keyword> keywords;
  std::vector<std::size_t> origins;  ///< of the translation's lines, in `lines`

  /// The line that a card of the translation comes from.
  [[nodiscard]] std::size_t line_of(const Card& card) const;
  /// The keyword, in `keywords`, to which a line belongs.
  [[nodiscard]] std::size_t keyword_at(std::size_t line) const;
  /// The keywords of a material: those from *MATERIAL on that describe it. One
  /// past the last.
  [[nodiscard]] std::size_t material_end(std::size_t keyword) const;
  /// A keyword's lines and its data, without comments.
  [[nodiscard]] KeywordText text_of(std::size_t keyword) const;
};

/// @throws InputError as read_bulk_data()
[[nodiscard]] KeywordDeck read_keyword_deck(const std::filesystem::path& path);

/// Gives an option another value, where a line has it.
void set_option(const std::string& name,
                const std::string& value,
                KeywordText& text);

/// Multiplies the numbers of the deck that one card has otherwise than the
/// other, which comes from it; integers of the two do not count.
///
/// @param text has the lines of the card's keywords
/// @return false where a number of the card stands nowhere in the deck by
///   itself
[[nodiscard]] bool scale_numbers(const KeywordDeck& deck,
                                 const Card& before,
                                 const Card& after,
                                 KeywordText& text);

}  // namespace tapfit::structure
