// What is known of an Abaqus or CalculiX deck while it is translated. Each
// group of keywords has a translator of its own; translate_inp runs them in
// order of dependence.
#pragma once

#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/card_lines.hpp"
#include "updating/structure/abaqus/element_types.hpp"
#include "updating/structure/abaqus/keyword_block.hpp"
#include "updating/structure/abaqus/left_out.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace tapfit::structure {

/// Of nodes and elements; ids of what is added lie above those of the deck.
inline constexpr int largest_inp_id = 999999999;

struct InpNode {
  int id = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Place place;
};

struct InpElement {
  int id = 0;
  const InpType* type = nullptr;  ///< none: not read, see InpDeck::left_out
  std::string type_name;
  std::vector<int> nodes;  ///< as written
  Place place;
  int property = 0;  ///< 0: no section yet

  [[nodiscard]] bool is(InpFamily family) const {
    return type != nullptr && type->family == family;
  }
};

/// Faces of elements, or nodes.
struct InpSurface {
  std::vector<std::vector<int>> faces;  ///< corners, then middles of sides
  std::vector<int> nodes;               ///< all, each once, in order
};

/// *ORIENTATION.
struct InpOrientation {
  bool cylindrical = false;
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  int turned_about = 0;  ///< 1..3; 0: not given
  double turn_deg = 0.0;

  /// Columns x, y, z at a place, in the deck's axes.
  [[nodiscard]] Eigen::Matrix3d axes(const Eigen::Vector3d& at) const;
};

/// *MATERIAL.
struct InpMaterial {
  Place place;
  /// "" none, else ISOTROPIC, ORTHOTROPIC, ENGINEERINGCONSTANTS, LAMINA,
  /// ANISOTROPIC.
  std::string type;
  std::vector<double> moduli;
  double density = 0.0;
  std::map<std::string, int> ids;  ///< of its MAT1, MAT8, MAT9, once written
};

/// What of one name is not read.
struct LeftOutCount {
  Place place;  ///< of the first
  int count = 0;
  std::string consequence;
};

struct InpDeck {
  std::vector<Keyword> keywords;
  int last_step = 1;  ///< whose boundary conditions hold
  std::vector<InpNode> nodes;
  std::unordered_map<int, std::size_t> node_index;
  std::vector<InpElement> elements;
  std::unordered_map<int, std::size_t> element_index;
  std::map<std::string, std::vector<int>> node_sets;
  std::map<std::string, std::vector<int>> element_sets;
  std::map<std::string, InpSurface> surfaces;
  std::map<std::string, InpOrientation> orientations;
  std::map<std::string, InpMaterial> materials;
  std::unordered_map<int, int> system_of_node;  ///< *TRANSFORM
  std::unordered_map<int, double> thickness_of_node;
  /// *RIGID BODY: the degrees of freedom 1 to 3 of this node are 4 to 6 of
  /// that.
  std::map<int, int> turning_node;
  CardLines cards;
  std::vector<std::string> named;     ///< "MAT1 1 is STEEL"
  std::vector<std::string> warnings;  ///< what else is to be said
  std::map<std::string, LeftOutCount> left_out;
  int next_element = 1;
  int next_grid = 1;
  int next_property = 1;
  int next_material = 1;
  int next_system = 1;

  /// @throws InputError where the node is not defined
  [[nodiscard]] const InpNode& node(int id, const Place& asks) const;

  /// The nodes of a set, or one by its id, as a data line names them.
  /// @throws InputError where there is no such set or node, or both
  [[nodiscard]] std::vector<int> nodes_of(const std::string& text,
                                          const Place& asks) const;
  /// The one node that an option names.
  /// @throws InputError where it names none or more
  [[nodiscard]] int one_node(const Keyword& keyword,
                             const std::string& option) const;
  /// As nodes_of() for elements; places in `elements`.
  [[nodiscard]] std::vector<std::size_t> elements_of(const std::string& text,
                                                     const Place& asks) const;
  /// The elements of the set that the option ELSET names.
  [[nodiscard]] std::vector<std::size_t> element_set(
      const Keyword& keyword) const;

  /// Keywords of a name that belong to the model.
  [[nodiscard]] std::vector<const Keyword*> of(const std::string& name) const;

  /// Adds a warning, once.
  void say(const std::string& text);
  /// Counts what is not read under a name.
  void leave_out(const std::string& name,
                 const Place& place,
                 const std::string& consequence);
  /// Says which card a name of the deck has become, and notes it beside it.
  void name_card(const std::string& card,
                 int id,
                 const std::string& name,
                 const Place& place);
};

/// What the deck has under a name.
/// @param kind "surface", for the message
/// @throws InputError where there is none
template <typename Named>
[[nodiscard]] auto& named_in(Named& all,
                             const std::string& name,
                             const std::string& kind,
                             const Place& asks) {
  const auto found = all.find(name);
  if (found == all.end()) {
    fail_at(asks,
            fmt::format("the {} {} is not defined",
                        kind,
                        name.empty() ? "\"\"" : shortened(name)),
            fmt::format("Define it by *{}, NAME=..., or correct the name.",
                        upper(kind)));
  }
  return found->second;
}

/// Joins what *PART, *INSTANCE and *ASSEMBLY hold into one model.
/// @throws InputError for more than one part or instance, or a moved one
void flatten_assembly(InpDeck& deck);

/// Names what is not read, in `left_out` and `warnings`; finds `last_step`.
/// @throws InputError for an *INCLUDE that names no file
void sort_keywords(InpDeck& deck);

void read_inp_nodes(InpDeck& deck);
void read_inp_elements(InpDeck& deck);
void read_inp_sets(InpDeck& deck);
void read_inp_surfaces(InpDeck& deck);
void read_inp_materials(InpDeck& deck);
void read_inp_orientations(InpDeck& deck);

/// Finds the nodes of `turning_node`; what they turn is known once
/// write_inp_rigids() has been.
void find_turning_nodes(InpDeck& deck);
/// Writes GRID and CORD2 cards.
void write_inp_grids(InpDeck& deck);
void write_solid_sections(InpDeck& deck);
void write_shell_sections(InpDeck& deck);
void write_beam_sections(InpDeck& deck);
void write_point_elements(InpDeck& deck);
/// Writes solids and trusses, which nothing of their sections changes.
/// @throws InputError for an element without section
void write_inp_elements(InpDeck& deck);
void write_inp_rigids(InpDeck& deck);
void write_inp_equations(InpDeck& deck);
void write_inp_ties(InpDeck& deck);
void write_inp_boundary(InpDeck& deck);

/// Elements of the families in the section's ELSET.
[[nodiscard]] std::vector<std::size_t> section_elements(
    const InpDeck& deck,
    const Keyword& section,
    const std::vector<InpFamily>& families);

/// Gives elements a property of their own, by a card of this name.
/// @return its id
/// @throws InputError for an element that has a section already
int take_elements(InpDeck& deck,
                  const Keyword& section,
                  const std::vector<std::size_t>& elements,
                  const std::string& card);

/// Id of the material's card of a kind, which is written where it has not been.
/// @param card "MAT1"; MAT8 and MAT9 become MAT1 for an isotropic material
/// @throws InputError for a material that has no moduli, or none of the kind
[[nodiscard]] int material_card(InpDeck& deck,
                                const std::string& name,
                                const std::string& card,
                                const Place& asks);

/// Whether a material is the same in all directions.
[[nodiscard]] bool is_isotropic(const InpDeck& deck, const std::string& name);

/// Writes CORD2R. @return its id
int write_axes(InpDeck& deck, const Eigen::Matrix3d& axes, const Place& place);

struct RelationTerm {
  int node = 0;
  int dof = 0;  ///< 1 to 6
  double factor = 0.0;
};

/// Writes an MPC: the sum of the terms is zero, the first one follows.
void write_relation(InpDeck& deck,
                    const Place& place,
                    const std::vector<RelationTerm>& terms);

}  // namespace tapfit::structure
