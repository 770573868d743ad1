#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/card_defaults.hpp"
#include "updating/structure/cards/error_notes.hpp"
#include "updating/structure/cards/listed.hpp"
#include "updating/structure/checks/attached_grids.hpp"
#include "updating/structure/checks/doubled_parts.hpp"
#include "updating/structure/checks/element_shapes.hpp"
#include "updating/structure/checks/number_scales.hpp"
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
  read_places(builder, bulk.cards);
  for (const CardTable& table : passes) {
    for (const Card& card : bulk.cards) {
      const auto reader = table.find(card.name());
      if (reader != table.end()) reader->second(builder, CardReader(card));
    }
  }
  place_scalar_points(builder);
  builder.hand_over_warnings();
  return builder;
}

std::string numbered(const char* name, std::size_t count) {
  return fmt::format("{} sets of {}", count, name);
}

// A case control that is solved as it stands and chooses no set holds nothing.
void warn_unasked(const CaseControl& control,
                  const char* name,
                  int set,
                  Deck& deck) {
  if (!control.for_modes) return;
  deck.warnings.push_back(fmt::format(
      "the case control chooses no {0}, so that Nastran would leave "
      "it out: set {1} holds here; write {0} = {1} there, or take "
      "its cards out if the model is meant without",
      name,
      set));
}

// All sets hold where none is chosen; that is said where it may not be meant.
void warn_unselected(const DeckBuilder& builder,
                     const CaseControl& control,
                     Deck& deck) {
  std::vector<std::string> sets;
  if (!control.spc_set && builder.constraint_sets.size() > 1) {
    sets.push_back(numbered("SPC", builder.constraint_sets.size()));
  }
  if (!control.mpc_set && builder.relation_sets.size() > 1) {
    sets.push_back(numbered("MPC", builder.relation_sets.size()));
  }
  if (!control.spc_set && builder.constraint_sets.size() == 1) {
    warn_unasked(control, "SPC", builder.constraint_sets.begin()->first, deck);
  }
  if (!control.mpc_set && builder.relation_sets.size() == 1) {
    warn_unasked(control, "MPC", builder.relation_sets.begin()->first, deck);
  }
  if (sets.empty()) return;
  deck.warnings.push_back(
      fmt::format("the case control chooses none of {}: all hold; choose one "
                  "there (SPC = n, MPC = n) if that is meant",
                  listed(sets)));
}

void warn_other_subcases(const CaseControl& control, Deck& deck) {
  if (control.other_spc_sets.empty()) return;
  std::vector<std::string> sets;
  for (const int set : control.other_spc_sets) {
    sets.push_back(fmt::format("{}", set));
  }
  deck.warnings.push_back(
      fmt::format("the case control also selects SPC {}: the model is held as "
                  "in its first subcase, by SPC {} alone",
                  listed(sets),
                  *control.spc_set));
}

// What the case control selects, and what is not read.
void finish(const BulkData& bulk,
            const UnsupportedCards& unsupported,
            DeckBuilder& builder) {
  Deck& deck = builder.deck;
  const CaseControl& control = bulk.control;
  apply_constraints(builder, control.spc_set);
  apply_relations(builder, control.mpc_set);
  apply_direct_matrices(
      builder, control.stiffness_matrices, control.mass_matrices);
  check_odd_materials(builder);
  warn_unselected(builder, control, deck);
  warn_other_subcases(control, deck);
  for (const auto& cards : {unsupported.needed, unsupported.others}) {
    for (const UnsupportedCard& card : cards) {
      deck.warnings.push_back(card.text);
    }
  }
  if (!unsupported.ignored.empty()) {
    deck.warnings.push_back(unsupported.ignored);
  }
}

// A matrix says nothing without the other one and the table of its rows.
void refuse_matrix(const std::filesystem::path& path) {
  std::ifstream file = acquisition::open_input(path);
  std::string first(14, ' ');
  file.read(first.data(), static_cast<std::streamsize>(first.size()));
  if (upper(first) != "%%MATRIXMARKET") return;
  throw InputError(
      "this is a matrix (Matrix Market), not a Nastran deck",
      path.string(),
      "Give the folder of a test.json that names stiffness, mass and a table "
      "of their rows: \"model\": {\"stiffness\": \"K.mtx\", \"mass\": "
      "\"M.mtx\", \"dofs\": \"dofs.csv\"}");
}

}  // namespace

Deck read_deck(const std::filesystem::path& path,
               const std::vector<std::string>& ignored) {
  refuse_matrix(path);
  BulkData bulk = read_bulk_data(path);
  fill_defaults(bulk);
  order_coordinate_cards(bulk.cards);
  const std::vector<CardTable> passes{scalar_point_cards(),
                                      grid_axes_cards(),
                                      material_cards(),
                                      property_cards(),
                                      section_cards(),
                                      laminate_cards(),
                                      scalar_property_cards(),
                                      element_cards(),
                                      solid_cards(),
                                      scalar_cards(),
                                      rigid_cards(),
                                      relation_cards(),
                                      constraint_cards(),
                                      direct_matrix_cards()};
  std::vector<CardTable> known = passes;
  known.push_back(coordinate_cards());
  known.push_back(grid_coordinate_cards());
  take_out(ignored, known, bulk);
  const UnsupportedCards unsupported = unsupported_cards(bulk, known);
  refuse_needed(unsupported, ignored);
  try {
    DeckBuilder builder = read_cards(bulk, passes);
    Deck& deck = builder.deck;
    deck.path = path;
    finish(bulk, unsupported, builder);
    if (deck.grids.empty()) {
      throw InputError(
          "the model has no GRID",
          path.string(),
          "Check that this is a Nastran, Abaqus or CalculiX deck.");
    }
    check_references(deck);
    check_number_scales(deck);
    warn_unattached(bulk, deck);
    for (std::string& text : bulk.warnings) {
      deck.warnings.push_back(std::move(text));
    }
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
    for (const UnsupportedCard& card : unsupported.others) {
      if (card.defines) causes.push_back(card.text);
    }
    throw with_notes(error, causes);
  }
}

}  // namespace tapfit::structure
