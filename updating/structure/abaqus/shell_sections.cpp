// *SHELL SECTION, *MEMBRANE SECTION: PSHELL and PCOMP, and the shells
// themselves, whose cards hold the material's angle, the offset and thicknesses
// of their own.
//
// Source: Abaqus Keywords Reference Guide and CalculiX CrunchiX User's Manual,
// entries of these names.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

struct ShellSection {
  const Keyword& keyword;
  std::vector<std::size_t> elements;
  std::string orientation;  // "" none
  double thickness = 0.0;
  double offset = 0.0;    // of the middle below the nodes, in thicknesses
  bool directed = false;  // its material has directions
  bool nodal = false;     // *NODAL THICKNESS counts
};

double thickness_in(const DataLine& line) {
  const double t = number_in(line, 0, "thickness");
  if (!(t > 0.0)) {
    fail_at(line.place,
            fmt::format("the thickness is {:g}", t),
            "Give one above zero.");
  }
  return t;
}

// SPOS and SNEG: the nodes lie on the top, on the bottom.
double offset_of(const Keyword& keyword) {
  const std::string text = keyword.option("OFFSET");
  if (text == "SPOS") return 0.5;
  if (text == "SNEG") return -0.5;
  return keyword.option_number("OFFSET");
}

// Direction 1 of the material near a shell's middle, in the deck's axes. Where
// no orientation is given it is x, or z where that is upright on the shell;
// with one its axis 1, or the one that follows the axis of its turn.
Eigen::Vector3d first_direction(const InpDeck& deck,
                                const std::string& orientation,
                                const Eigen::Vector3d& at,
                                const Eigen::Vector3d& normal) {
  constexpr double upright = 0.9999984;  // cosine of 0.1 degree
  Eigen::Matrix3d axes;
  axes << Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(),
      Eigen::Vector3d::UnitY();
  if (!orientation.empty()) {
    const InpOrientation& o = deck.orientations.at(orientation);
    axes = o.axes(at);
    if (o.turned_about > 0) return axes.col(o.turned_about % 3);
  }
  return std::abs(normal.dot(axes.col(0))) < upright ? axes.col(0)
                                                     : axes.col(1);
}

// From side 1-2 to direction 1 as it lies on the shell.
double material_angle_deg(const InpDeck& deck,
                          const InpElement& e,
                          const std::string& orientation) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> at;
  for (std::size_t k = 0; k < e.type->corners; ++k) {
    at.push_back(deck.node(e.nodes[k], e.place).at);
    middle += at.back() / static_cast<double>(e.type->corners);
  }
  const Eigen::Vector3d side = at[1] - at[0];
  const Eigen::Vector3d normal = side.cross(at[2] - at[0]).stableNormalized();
  const Eigen::Vector3d x = first_direction(deck, orientation, middle, normal);
  const Eigen::Vector3d flat = x - normal * normal.dot(x);
  return std::atan2(normal.dot(side.cross(flat)), side.dot(flat)) * 180.0 /
         std::numbers::pi;
}

// Where a shell's card has what; fields behind the name.
struct ShellPlaces {
  std::size_t theta, offset, thickness, count;
};

ShellPlaces places_of(const InpType& type) {
  const std::string card = type.card;
  if (card == "CQUAD4") return {6, 7, 10, 14};
  if (card == "CTRIA3") return {5, 6, 10, 13};
  return card == "CQUAD8" ? ShellPlaces{14, 15, 10, 17}
                          : ShellPlaces{8, 9, 10, 13};
}

void write_shell(InpDeck& deck, const InpElement& e, const ShellSection& own) {
  const ShellPlaces at = places_of(*e.type);
  CardFields fields{e.id, e.property};
  fields.insert(fields.end(), e.nodes.begin(), e.nodes.end());
  fields.resize(std::max(fields.size(), at.count));
  double mean = 0.0;
  for (std::size_t k = 0; k < e.type->corners; ++k) {
    const auto given = deck.thickness_of_node.find(e.nodes[k]);
    const bool there = own.nodal && given != deck.thickness_of_node.end();
    const double t = there ? given->second : own.thickness;
    mean += t / static_cast<double>(e.type->corners);
    if (there) fields[at.thickness + k] = t;
  }
  if (own.directed) {
    fields[at.theta] = material_angle_deg(deck, e, own.orientation);
  }
  if (own.offset != 0.0) fields[at.offset] = -own.offset * mean;
  deck.cards.card(e.place, e.type->card, fields);
}

// The angle of a layer: a number, or an orientation, which is turned against
// the section's as both lie on the first element.
double ply_angle_deg(const InpDeck& deck,
                     const ShellSection& own,
                     const DataLine& line) {
  const std::string turn = line.name(3);
  const bool number =
      turn.find_first_not_of("0123456789.+-ED") == std::string::npos;
  if (number) return number_or(line, 3, 0.0, "angle");
  static_cast<void>(
      named_in(deck.orientations, turn, "orientation", line.place));
  if (own.elements.empty()) return 0.0;
  const InpElement& first = deck.elements[own.elements.front()];
  return material_angle_deg(deck, first, turn) -
         material_angle_deg(deck, first, own.orientation);
}

// Layers from the bottom: thickness, points, material, angle.
void write_composite(InpDeck& deck, ShellSection& own) {
  own.directed = true;
  CardFields layers;
  for (const DataLine& line : own.keyword.lines) {
    const double thickness = thickness_in(line);
    own.thickness += thickness;
    layers.emplace_back(material_card(deck, line.name(2), "MAT8", line.place));
    layers.emplace_back(thickness);
    layers.emplace_back(ply_angle_deg(deck, own, line));
    layers.emplace_back();
  }
  if (layers.empty()) {
    own.keyword.fail("the laminate has no layer",
                     "Give thickness, points, material and angle of each.");
  }
  const int id = take_elements(deck, own.keyword, own.elements, "PCOMP");
  CardFields fields{id};
  if (own.offset != 0.0) {
    fields.emplace_back((-0.5 - own.offset) * own.thickness);
  }
  own.offset = 0.0;  // Z0 has it
  fields.resize(8);
  fields.insert(fields.end(), layers.begin(), layers.end());
  deck.cards.card(own.keyword.place, "PCOMP", fields);
}

// Of the data line; without one, where nodes have thicknesses, the first's.
double thickness_of(const InpDeck& deck, const ShellSection& own) {
  if (own.nodal && own.keyword.lines.empty() && !own.elements.empty()) {
    const int node = deck.elements[own.elements.front()].nodes.front();
    const auto given = deck.thickness_of_node.find(node);
    if (given != deck.thickness_of_node.end()) return given->second;
  }
  return thickness_in(own.keyword.line(0, "thickness"));
}

void write_plain(InpDeck& deck, ShellSection& own) {
  const Keyword& keyword = own.keyword;
  const std::string name = keyword.needed_option("MATERIAL");
  own.thickness = thickness_of(deck, own);
  own.directed = !is_isotropic(deck, name);
  const int material = material_card(deck, name, "MAT8", keyword.place);
  const int id = take_elements(deck, keyword, own.elements, "PSHELL");
  CardFields fields{id, material, own.thickness};
  if (keyword.name != "MEMBRANESECTION") {
    fields.insert(fields.end(), {material, "", material});
  }
  deck.cards.card(keyword.place, "PSHELL", fields);
}

void write_shell_section(InpDeck& deck, const Keyword& keyword) {
  const InpFamily family = keyword.name == "MEMBRANESECTION"
                               ? InpFamily::Membrane
                               : InpFamily::Shell;
  ShellSection own{keyword,
                   section_elements(deck, keyword, {family}),
                   keyword.option("ORIENTATION")};
  own.offset = offset_of(keyword);
  own.nodal = keyword.has("NODALTHICKNESS");
  if (!own.nodal && !deck.thickness_of_node.empty()) {
    deck.say(keyword.place.where +
             ": *NODAL THICKNESS counts only where the section has the option "
             "NODAL THICKNESS, as in Abaqus and CalculiX");
  }
  if (!own.orientation.empty()) {
    static_cast<void>(named_in(
        deck.orientations, own.orientation, "orientation", keyword.place));
  }
  if (keyword.has("COMPOSITE")) {
    write_composite(deck, own);
  } else if (keyword.name == "SHELLGENERALSECTION" &&
             !keyword.has("MATERIAL")) {
    keyword.fail("a section given by its stiffness matrix is not read",
                 "Give MATERIAL or COMPOSITE.");
  } else {
    write_plain(deck, own);
  }
  for (const std::size_t k : own.elements) {
    write_shell(deck, deck.elements[k], own);
  }
}

}  // namespace

void write_shell_sections(InpDeck& deck) {
  for (const char* name :
       {"SHELLSECTION", "SHELLGENERALSECTION", "MEMBRANESECTION"}) {
    for (const Keyword* keyword : deck.of(name))
      write_shell_section(deck, *keyword);
  }
}

}  // namespace tapfit::structure
