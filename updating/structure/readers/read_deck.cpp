#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/card_defaults.hpp"
#include "updating/structure/cards/error_notes.hpp"
#include "updating/structure/cards/listed.hpp"
#include "updating/structure/checks/attached_grids.hpp"
#include "updating/structure/checks/doubled_parts.hpp"
#include "updating/structure/checks/element_shapes.hpp"
#include "updating/structure/checks/weak_properties.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/readers/deck_builder.hpp"
#include "updating/structure/readers/unsupported_cards.hpp"

#include <fmt/format.h>

#include <fstream>

namespace tapfit::structure {
namespace {

DeckBuilder read_cards(const BulkData& bulk,
                       const std::vector<CardTable>& passes) {
  DeckBuilder builder;
  builder.deck.cards = bulk.lines;
  for (const CardTable& table : passes) {
    for (const Card& card : bulk.cards) {
      const auto reader = table.find(card.name());
      if (reader != table.end()) reader->second(builder, CardReader(card));
    }
  }
  builder.hand_over_warnings();
  return builder;
}

void warn_other_subcases(const BulkData& bulk, Deck& deck) {
  if (bulk.other_spc_sets.empty()) return;
  std::vector<std::string> sets;
  for (const int set : bulk.other_spc_sets) {
    sets.push_back(fmt::format("{}", set));
  }
  deck.warnings.push_back(
      fmt::format("the case control also selects SPC {}: the model is held as "
                  "in its first subcase, by SPC {} alone",
                  listed(sets),
                  *bulk.spc_set));
}

// A matrix says nothing without the other one and the table of its rows.
void refuse_matrix(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string first;
  std::getline(file, first);
  if (!upper(first).starts_with("%%MATRIXMARKET")) return;
  throw InputError(
      "this is a matrix (Matrix Market), not a Nastran deck",
      path.string(),
      "Give the folder of a test.json that names stiffness, mass and a table "
      "of their rows: \"model\": {\"stiffness\": \"K.mtx\", \"mass\": "
      "\"M.mtx\", \"dofs\": \"dofs.csv\"}");
}

}  // namespace

Deck read_deck(const std::filesystem::path& path) {
  refuse_matrix(path);
  BulkData bulk = read_bulk_data(path);
  fill_defaults(bulk);
  order_coordinate_cards(bulk.cards);
  const std::vector<CardTable> passes{coordinate_cards(),
                                      grid_cards(),
                                      grid_coordinate_cards(),
                                      grid_axes_cards(),
                                      property_cards(),
                                      element_cards(),
                                      rigid_cards(),
                                      constraint_cards()};
  const std::vector<UnsupportedCard> unsupported =
      unsupported_cards(bulk, passes);
  try {
    DeckBuilder builder = read_cards(bulk, passes);
    Deck& deck = builder.deck;
    deck.path = path;
    apply_constraints(builder, bulk.spc_set);
    warn_other_subcases(bulk, deck);
    for (const UnsupportedCard& card : unsupported) {
      deck.warnings.push_back(card.text);
    }
    if (deck.grids.empty()) {
      throw InputError("the model has no GRID",
                       path.string(),
                       "Check that this is Nastran bulk data.");
    }
    check_references(deck);
    warn_unattached(bulk, deck);
    for (std::string& text : weak_property_warnings(deck)) {
      deck.warnings.push_back(std::move(text));
    }
    for (std::string& text : doubled_part_warnings(deck)) {
      deck.warnings.push_back(std::move(text));
    }
    for (std::string& text : element_shape_warnings(deck)) {
      deck.warnings.push_back(std::move(text));
    }
    return std::move(builder.deck);
  } catch (const InputError& error) {
    std::vector<std::string> causes;
    for (const UnsupportedCard& card : unsupported) {
      if (card.defines) causes.push_back(card.text);
    }
    throw with_notes(error, causes);
  }
}

}  // namespace tapfit::structure
