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

// A set that a case control does not choose is not in the model, as in Nastran.
template <typename Sets>
void drop_unchosen(const char* name, Sets& sets, Deck& deck) {
  if (sets.empty()) return;
  std::vector<std::string> ids;
  for (const auto& [id, members] : sets) ids.push_back(fmt::format("{}", id));
  deck.warnings.push_back(
      fmt::format("the case control chooses no {0}: set {1} is not in the "
                  "model, as in Nastran; write {0} = {2} there if it is meant",
                  name,
                  listed(ids),
                  ids.front()));
  sets.clear();
}

// Without a case control all sets hold; of several that is said.
void warn_unselected(const DeckBuilder& builder, Deck& deck) {
  std::vector<std::string> sets;
  if (builder.constraint_sets.size() > 1) {
    sets.push_back(numbered("SPC", builder.constraint_sets.size()));
  }
  if (builder.relation_sets.size() > 1) {
    sets.push_back(numbered("MPC", builder.relation_sets.size()));
  }
  if (sets.empty()) return;
  deck.warnings.push_back(
      fmt::format("no case control chooses among {}: all hold; choose one "
                  "there (SPC = n, MPC = n) if that is meant",
                  listed(sets)));
}

void drop_unchosen(const CaseControl& control, DeckBuilder& builder) {
  if (!control.selects) {
    warn_unselected(builder, builder.deck);
    return;
  }
  if (!control.spc_set) {
    drop_unchosen("SPC", builder.constraint_sets, builder.deck);
  }
  if (!control.mpc_set) {
    drop_unchosen("MPC", builder.relation_sets, builder.deck);
  }
}

void warn_other_subcases(const CaseControl& control, Deck& deck) {
  if (control.other_spc_sets.empty()) return;
  std::vector<std::string> sets;
  for (const int set : control.other_spc_sets) {
    sets.push_back(fmt::format("{}", set));
  }
  const std::string subcase =
      control.first
          ? "its first subcase"
          : fmt::format("its subcase {}, the first for modes", control.subcase);
  deck.warnings.push_back(fmt::format(
      "the case control also selects SPC {}: the model is held as "
      "in {}, by {}",
      listed(sets),
      subcase,
      control.spc_set ? fmt::format("SPC {} alone", *control.spc_set)
                      : "none"));
}

// What the case control selects, and what is not read.
void finish(const BulkData& bulk,
            const UnsupportedCards& unsupported,
            DeckBuilder& builder) {
  Deck& deck = builder.deck;
  const CaseControl& control = bulk.control;
  drop_unchosen(control, builder);
  apply_constraints(builder, control.spc_set);
  apply_relations(builder, control.mpc_set);
  apply_direct_matrices(builder, control);
  check_odd_materials(builder);
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
