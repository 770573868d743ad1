// *SOLID SECTION, *SHELL SECTION, *MEMBRANE SECTION: PSOLID, PROD, PSHELL and
// PCOMP, and the shells themselves, whose cards hold the material's angle, the
// offset and thicknesses of their own.
//
// Source: Abaqus Keywords Reference Guide and CalculiX CrunchiX User's Manual,
// entries of these names.
#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

// A layer, from the bottom.
struct InpPly {
  double thickness = 0.0;
  std::string material;
  std::string orientation;  // a name, or "" where `angle_deg` holds
  double angle_deg = 0.0;
  Place place;
};

struct ShellSection {
  double thickness = 0.0;
  double offset = 0.0;      // of the middle below the nodes, in thicknesses
  std::string orientation;  // "" none
  bool directed = false;    // its material has directions
  bool nodal = false;       // *NODAL THICKNESS counts
};

std::vector<std::size_t> members(const InpDeck& deck,
                                 const Keyword& keyword,
                                 std::initializer_list<InpFamily> families) {
  std::vector<std::size_t> found;
  const std::string set = keyword.needed_option("ELSET");
  for (const std::size_t k : deck.elements_of(set, keyword.place)) {
    const InpType* type = deck.elements[k].type;
    if (type != nullptr &&
        std::ranges::find(families, type->family) != families.end()) {
      found.push_back(k);
    }
  }
  return found;
}

double thickness_in(const DataLine& line, std::size_t field) {
  const double t = number_in(line, field, "thickness");
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
  if (text.empty()) return 0.0;
  if (text == "SPOS") return 0.5;
  if (text == "SNEG") return -0.5;
  const DataLine line{{text}, keyword.place, false};
  return number_in(line, 0, "OFFSET");
}

// Direction 1 of the material near a shell's middle, in the deck's axes. Where
// no orientation is given it is x, or z where that is upright on the shell;
// with one its axis 1, or the one that follows the axis of its turn.
Eigen::Vector3d first_direction(const InpDeck& deck,
                                const std::string& orientation,
                                const Eigen::Vector3d& at,
                                const Eigen::Vector3d& normal) {
  constexpr double upright = 0.9999984;  // cosine of 0.1 degree
  if (orientation.empty()) {
    return std::abs(normal.x()) < upright
               ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
               : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  }
  const InpOrientation& o = deck.orientations.at(orientation);
  const Eigen::Matrix3d axes = o.axes(at);
  if (o.turned_about > 0) return axes.col(o.turned_about % 3);
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
  std::vector<std::string> fields{fmt::format("{}", e.id),
                                  fmt::format("{}", e.property)};
  for (const int node : e.nodes) fields.push_back(fmt::format("{}", node));
  fields.resize(std::max(fields.size(), at.count));
  double mean = 0.0;
  for (std::size_t k = 0; k < e.type->corners; ++k) {
    const auto given = deck.thickness_of_node.find(e.nodes[k]);
    const bool there = own.nodal && given != deck.thickness_of_node.end();
    const double t = there ? given->second : own.thickness;
    mean += t / static_cast<double>(e.type->corners);
    if (there) fields[at.thickness + k] = real_field(t);
  }
  if (own.directed) {
    fields[at.theta] = real_field(material_angle_deg(deck, e, own.orientation));
  }
  if (own.offset != 0.0) {
    fields[at.offset] = real_field(-own.offset * mean);
  }
  deck.cards.card(e.place, e.type->card, fields);
}

// Takes the elements for a property and says so.
int take(InpDeck& deck,
         const Keyword& keyword,
         const std::vector<std::size_t>& elements,
         const std::string& card) {
  const int id = deck.next_property++;
  for (const std::size_t k : elements) deck.elements[k].property = id;
  const std::string set = keyword.option("ELSET");
  deck.cards.comment(
      fmt::format("{} {}: *{} of {}", card, id, keyword.shown, set),
      keyword.place);
  deck.named.push_back(fmt::format("{} {} is {}", card, id, set));
  return id;
}

std::vector<InpPly> plies_of(const Keyword& keyword) {
  std::vector<InpPly> plies;
  for (const DataLine& line : keyword.lines) {
    InpPly ply;
    ply.thickness = thickness_in(line, 0);
    ply.material = upper(line.text(2));
    ply.place = line.place;
    const std::string turn = line.text(3);
    const bool number =
        !turn.empty() &&
        turn.find_first_not_of("0123456789.+-eEdD") == std::string::npos;
    if (number) {
      ply.angle_deg = number_in(line, 3, "angle");
    } else {
      ply.orientation = upper(turn);
    }
    plies.push_back(ply);
  }
  if (plies.empty()) {
    keyword.fail("the laminate has no layer",
                 "Give thickness, points, material and angle of each.");
  }
  return plies;
}

// Layers that name an orientation are turned by its angle against the
// section's, as they lie on the first element.
void write_composite(InpDeck& deck,
                     const Keyword& keyword,
                     const std::vector<std::size_t>& elements,
                     ShellSection& own) {
  const std::vector<InpPly> plies = plies_of(keyword);
  own.directed = true;
  std::vector<std::string> layers;
  for (const InpPly& ply : plies) {
    double angle = ply.angle_deg;
    if (!ply.orientation.empty() && !elements.empty()) {
      static_cast<void>(orientation_of(deck, ply.orientation, ply.place));
      const InpElement& first = deck.elements[elements.front()];
      angle = material_angle_deg(deck, first, ply.orientation) -
              material_angle_deg(deck, first, own.orientation);
    }
    own.thickness += ply.thickness;
    const int material = material_card(deck, ply.material, "MAT8", ply.place);
    layers.push_back(fmt::format("{}", material));
    layers.push_back(real_field(ply.thickness));
    layers.push_back(real_field(angle));
    layers.emplace_back();
  }
  const double bottom = (-0.5 - own.offset) * own.thickness;
  const int id = take(deck, keyword, elements, "PCOMP");
  std::vector<std::string> fields{fmt::format("{}", id),
                                  own.offset == 0.0 ? "" : real_field(bottom)};
  fields.resize(8);
  fields.insert(fields.end(), layers.begin(), layers.end());
  deck.cards.card(keyword.place, "PCOMP", fields);
  own.offset = 0.0;  // Z0 has it
}

// Of the data line; without one, where nodes have thicknesses, the first's.
double thickness_of(const InpDeck& deck,
                    const Keyword& keyword,
                    const std::vector<std::size_t>& elements) {
  if (keyword.has("NODALTHICKNESS") && keyword.lines.empty() &&
      !elements.empty()) {
    const int node = deck.elements[elements.front()].nodes.front();
    const auto given = deck.thickness_of_node.find(node);
    if (given != deck.thickness_of_node.end()) return given->second;
  }
  return thickness_in(keyword.line(0, "thickness"), 0);
}

void write_plain(InpDeck& deck,
                 const Keyword& keyword,
                 const std::vector<std::size_t>& elements,
                 ShellSection& own) {
  const std::string name = keyword.needed_option("MATERIAL");
  own.thickness = thickness_of(deck, keyword, elements);
  own.directed = !is_isotropic(deck, name, keyword.place);
  const bool membrane = keyword.name == "MEMBRANESECTION";
  const std::string material =
      fmt::format("{}", material_card(deck, name, "MAT8", keyword.place));
  const int id = take(deck, keyword, elements, "PSHELL");
  std::vector<std::string> fields{
      fmt::format("{}", id), material, real_field(own.thickness)};
  if (!membrane) {
    fields.push_back(material);
    fields.emplace_back();
    fields.push_back(material);
  }
  deck.cards.card(keyword.place, "PSHELL", fields);
}

void write_shell_section(InpDeck& deck, const Keyword& keyword) {
  const bool membrane = keyword.name == "MEMBRANESECTION";
  const auto elements = members(
      deck, keyword, {membrane ? InpFamily::Membrane : InpFamily::Shell});
  ShellSection own;
  own.offset = offset_of(keyword);
  own.nodal = keyword.has("NODALTHICKNESS");
  if (!own.nodal && !deck.thickness_of_node.empty()) {
    say(deck,
        keyword.place.where +
            ": *NODAL THICKNESS counts only where the section has the option "
            "NODAL THICKNESS, as in Abaqus and CalculiX");
  }
  own.orientation = keyword.option("ORIENTATION");
  if (!own.orientation.empty()) {
    static_cast<void>(orientation_of(deck, own.orientation, keyword.place));
  }
  const bool general = keyword.name == "SHELLGENERALSECTION";
  if (keyword.has("COMPOSITE")) {
    write_composite(deck, keyword, elements, own);
  } else if (general && !keyword.has("MATERIAL")) {
    keyword.fail("a section given by its stiffness matrix is not read",
                 "Give MATERIAL or COMPOSITE.");
  } else {
    write_plain(deck, keyword, elements, own);
  }
  for (const std::size_t k : elements) {
    write_shell(deck, deck.elements[k], own);
  }
}

// Axes of a material that has directions; "" for the deck's own.
std::string solid_axes(InpDeck& deck, const Keyword& keyword) {
  const std::string name = keyword.option("ORIENTATION");
  if (name.empty()) return "";
  const InpOrientation& o = orientation_of(deck, name, keyword.place);
  if (is_isotropic(deck, keyword.option("MATERIAL"), keyword.place)) return "";
  if (o.cylindrical) {
    keyword.fail("a cylindrical orientation of a solid is not read",
                 "Split the set into sectors with a rectangular one each.");
  }
  const Eigen::Matrix3d axes = o.axes(Eigen::Vector3d::Zero());
  return fmt::format("{}", write_axes(deck, axes, keyword.place));
}

void write_solid_section(InpDeck& deck, const Keyword& keyword) {
  const std::string name = keyword.needed_option("MATERIAL");
  const auto solids = members(deck, keyword, {InpFamily::Solid});
  const auto trusses = members(deck, keyword, {InpFamily::Truss});
  if (keyword.has("COMPOSITE")) {
    keyword.fail("layered solids are not read",
                 "Use an element through the thickness for each layer.");
  }
  if (!solids.empty()) {
    const int material = material_card(deck, name, "MAT9", keyword.place);
    const std::string system = solid_axes(deck, keyword);
    const int id = take(deck, keyword, solids, "PSOLID");
    deck.cards.card(keyword.place,
                    "PSOLID",
                    {fmt::format("{}", id),
                     fmt::format("{}", material),
                     system.empty() ? "0" : system});
  }
  if (!trusses.empty()) {
    const double area = number_in(keyword.line(0, "area"), 0, "area");
    const int material = material_card(deck, name, "MAT1", keyword.place);
    const int id = take(deck, keyword, trusses, "PROD");
    deck.cards.card(
        keyword.place,
        "PROD",
        {fmt::format("{}", id), fmt::format("{}", material), real_field(area)});
  }
  if (solids.empty() && trusses.empty()) {
    static_cast<void>(material_card(deck, name, "MAT9", keyword.place));
  }
}

}  // namespace

void write_inp_sections(InpDeck& deck) {
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    if (keyword.name == "SOLIDSECTION") {
      write_solid_section(deck, keyword);
    } else if (keyword.name == "SHELLSECTION" ||
               keyword.name == "SHELLGENERALSECTION" ||
               keyword.name == "MEMBRANESECTION") {
      write_shell_section(deck, keyword);
    }
  }
}

}  // namespace tapfit::structure
