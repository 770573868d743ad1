// The room updating/structure/readers. From cards to a deck: one reader per
// group of cards, Matrix Market files, units.
// In:  The path of a model.
// Out: Deck in SI, or an InputError with file, line and field.
// May include: its row in CONTRIBUTING.md.
//
// What is known of a deck while its cards are being read. Each group of cards
// has a reader of its own (read_coordinates, read_grids, read_materials,
// read_sections, read_laminates, read_properties, read_elements, read_solids,
// read_scalars, read_rigid, read_rbe3, read_relations, read_constraints,
// read_direct); read_deck runs them in order of dependence.
#pragma once

#include "updating/structure/cards/card_reader.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tapfit::structure {

/// PBUSH.
struct BushProperty {
  std::array<double, 6> stiffness{};
  std::array<double, 6> damping{};
};

/// A DMIG matrix, with the place of its head.
struct DirectMatrix {
  std::string where;
  int form = 0;
  std::vector<MatrixTerm> terms;
};

struct DeckBuilder {
  Deck deck;
  std::unordered_map<int, std::size_t> grid_index;
  std::map<int, std::array<double, 2>> spring_properties;  ///< PELAS: k, g
  std::map<int, double> damper_properties;                 ///< PDAMP: B
  std::map<int, double> mass_properties;                   ///< PMASS: M
  /// PBUSH1D: k, c, m.
  std::map<int, std::array<double, 3>> line_spring_properties;
  std::map<int, BushProperty> bush_properties;  ///< PBUSH
  /// DMIG, by name, in the deck's order.
  std::map<std::string, DirectMatrix> direct_matrices;
  std::map<int, std::vector<Constraint>> constraint_sets;
  std::map<int, std::vector<int>> added_sets;           ///< SPCADD
  std::vector<Constraint> permanent;                    ///< GRID field 8
  std::map<int, std::vector<Relation>> relation_sets;   ///< MPC
  std::map<int, std::vector<int>> added_relation_sets;  ///< MPCADD
  /// MAT1 whose E and G no isotropic material has.
  std::set<int> odd_materials;
  std::set<int> element_ids;
  /// Where a property, material or system of an id was read.
  std::map<std::pair<std::string, int>, std::string> defined;

  /// @throws InputError when the grid does not exist
  [[nodiscard]] const Grid& grid(const CardReader& card, int id) const;

  /// @throws InputError when the system does not exist
  [[nodiscard]] const CoordinateSystem& system(const CardReader& card,
                                               int id) const;

  /// Takes an id among those of a kind ("material", "PSHELL").
  /// @throws InputError naming both cards when it is taken already
  void define(const CardReader& card, const std::string& kind, int id);

  /// Takes an element id. @throws InputError when it is taken already
  void claim(const CardReader& card, int id);

  /// Equal texts about cards of one name become one warning with a count.
  void warn(const CardReader& card, const std::string& text);

  /// Puts what warn() took into the deck.
  void hand_over_warnings();

 private:
  struct Warning {
    std::string where;  // of the first
    std::string text;
    int count = 0;
  };
  std::vector<Warning> warnings_;
  std::map<std::pair<std::string, std::string>, std::size_t> warned_;
};

using ReadCard = std::function<void(DeckBuilder&, const CardReader&)>;
using CardTable = std::map<std::string, ReadCard>;

/// Reads coordinate systems and grids.
/// @throws InputError where one refers to what does not exist, or to itself
///   round a ring
void read_places(DeckBuilder& builder, const std::vector<Card>& cards);

/// Tables of the cards each reader understands. The axes of grids need systems
/// on grids (CORD1R).
[[nodiscard]] CardTable coordinate_cards();
/// Puts each coordinate_cards() behind the one that it refers to; decks have
/// them in any order.
/// @throws InputError where they refer to each other in a ring
void order_coordinate_cards(std::vector<Card>& cards);
[[nodiscard]] CardTable grid_cards();
[[nodiscard]] CardTable grid_coordinate_cards();
[[nodiscard]] CardTable grid_axes_cards();
[[nodiscard]] CardTable scalar_point_cards();
[[nodiscard]] CardTable material_cards();
[[nodiscard]] CardTable property_cards();
[[nodiscard]] CardTable section_cards();
[[nodiscard]] CardTable laminate_cards();
[[nodiscard]] CardTable scalar_property_cards();
[[nodiscard]] CardTable element_cards();
[[nodiscard]] CardTable solid_cards();
[[nodiscard]] CardTable scalar_cards();
[[nodiscard]] CardTable rigid_cards();
[[nodiscard]] CardTable relation_cards();
[[nodiscard]] CardTable constraint_cards();
[[nodiscard]] CardTable direct_matrix_cards();

void read_pbush(DeckBuilder& builder, const CardReader& card);
void read_cbush(DeckBuilder& builder, const CardReader& card);
void read_rbe1(DeckBuilder& builder, const CardReader& card);
void read_rbe3(DeckBuilder& builder, const CardReader& card);
void read_rrod(DeckBuilder& builder, const CardReader& card);

/// Puts SPOINTs in the middle of the grids.
void place_scalar_points(DeckBuilder& builder);

/// @throws InputError for a MAT1 with E and G that no isotropic material has
///   where more than bars and rods have it; else warns of it
void check_odd_materials(DeckBuilder& builder);

/// Puts the constraints of the chosen set (all sets when none is chosen) into
/// the deck.
void apply_constraints(DeckBuilder& builder, std::optional<int> chosen);

/// Puts the MPCs of the chosen set (all sets when none is chosen) into the
/// deck.
void apply_relations(DeckBuilder& builder, std::optional<int> chosen);

/// Puts the DMIG matrices that the case control selects into the deck; without
/// a case control those of the usual names (KAAX, MAAX, K2GG, M2GG).
void apply_direct_matrices(DeckBuilder& builder, const CaseControl& control);

/// Id of the grid that a field names.
/// @throws InputError when there is none
[[nodiscard]] int existing_grid(const DeckBuilder& builder,
                                const CardReader& card,
                                std::size_t field);

/// The id, if it is one of the properties'.
/// @throws InputError naming the kind of property when it is not
template <typename Properties>
int property_of(const CardReader& card,
                const Properties& properties,
                int id,
                const std::string& kind) {
  if (!properties.contains(id)) {
    card.fail(kind + " " + std::to_string(id) + " does not exist",
              "Add the property or correct the entry.");
  }
  return id;
}

/// A property or material with its id and place, the id taken.
/// @param kind as in DeckBuilder::define
template <typename Property>
Property defined_by(DeckBuilder& builder,
                    const CardReader& card,
                    const std::string& kind,
                    const char* meaning = "PID") {
  Property p;
  p.id = card.id(1, meaning);
  builder.define(card, kind, p.id);
  p.where = card.where();
  return p;
}

/// An element with its id and place, the id taken.
template <typename Element>
Element claimed_by(DeckBuilder& builder, const CardReader& card) {
  Element e;
  e.id = card.id(1, "EID");
  e.where = card.where();
  builder.claim(card, e.id);
  return e;
}

/// Reads the corners of a shell or solid from field 4 on, then the grids in the
/// middle of its edges: 0 where one is blank, none where all are.
template <typename Element>
void read_corners(const DeckBuilder& builder,
                  const CardReader& card,
                  std::size_t corners,
                  std::size_t edges,
                  Element& e) {
  for (std::size_t i = 0; i < corners; ++i) {
    e.grids.push_back(existing_grid(builder, card, 3 + i));
  }
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t at = 3 + corners + i;
    const bool none = card.integer_or(at, 0, "grid") == 0;
    e.mids.push_back(none ? 0 : existing_grid(builder, card, at));
  }
  if (std::ranges::all_of(e.mids, [](int id) { return id == 0; })) {
    e.mids.clear();
  }
}

/// Cross section of a PBARL. @return empty for a type that is not known
[[nodiscard]] std::optional<BarProperty> section_of(
    const std::string& type, const std::vector<double>& dimensions);

/// All types of section_of(), with commas between.
[[nodiscard]] std::string known_sections();

/// Number of dimensions of a PBARL type, 0 when it is not known.
[[nodiscard]] std::size_t section_dimensions(const std::string& type);

}  // namespace tapfit::structure
