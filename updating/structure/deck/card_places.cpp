#include "updating/structure/deck/card_places.hpp"

#include "updating/structure/cards/bulk_numbers.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/card_reader.hpp"

#include <fmt/format.h>

#include <optional>

namespace tapfit::structure {
namespace {

std::optional<Card> find_card(const Deck& deck,
                              const std::set<std::string>& names,
                              int id) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(deck.path, error)) return {};
  try {
    for (const Card& card : read_bulk_data(deck.path).cards) {
      if (!names.contains(card.name()) || card.fields.size() < 2) continue;
      if (parse_integer(card.fields[1]) == id) return card;
    }
  } catch (const InputError&) {
    return {};  // changed since it was read
  }
  return {};
}

}  // namespace

std::string card_where(const Deck& deck,
                       const std::set<std::string>& names,
                       int id) {
  const std::optional<Card> card = find_card(deck, names, id);
  return card ? CardReader(*card).where() : "";
}

std::string grid_place(const Deck& deck, int id) {
  const std::optional<Card> card = find_card(deck, {"GRID"}, id);
  if (!card) return fmt::format("GRID {}", id);
  return fmt::format("GRID {} ({})", id, card->where);
}

}  // namespace tapfit::structure
