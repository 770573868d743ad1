// *BEAM SECTION and *BEAM GENERAL SECTION: PBEAML or PBEAM, and CBEAM. A beam
// with a node in its middle becomes two.
#include "updating/structure/abaqus/beam_shapes.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>

namespace tapfit::structure {
namespace {

struct BeamSection {
  BeamShape shape;
  Eigen::Vector3d n1{0.0, 0.0, -1.0};  // where none is given
};

// E, G of *BEAM GENERAL SECTION without MATERIAL.
int own_material(InpDeck& deck, const Keyword& keyword) {
  const DataLine& line = keyword.line(2, "E, G");
  const int id = deck.next_material++;
  deck.name_card(
      "MAT1", id, "the material of " + keyword.option("ELSET"), line.place);
  deck.cards.card(line.place,
                  "MAT1",
                  {id,
                   number_in(line, 0, "E"),
                   number_in(line, 1, "G"),
                   "",
                   keyword.option_number("DENSITY")});
  return id;
}

// OFFSET1 and OFFSET2 are in sizes of the section.
BeamSection section_of(const Keyword& keyword) {
  const bool general =
      keyword.name == "BEAMGENERALSECTION" && !keyword.has("SECTION");
  const std::string type =
      general ? "GENERAL" : keyword.needed_option("SECTION");
  BeamSection own{beam_shape(type, keyword.line(0, "dimensions"))};
  const Eigen::Vector2d offset(keyword.option_number("OFFSET1"),
                               keyword.option_number("OFFSET2"));
  own.shape.axis -= offset.cwiseProduct(own.shape.size);
  if (keyword.lines.size() > 1) {
    const Eigen::Vector3d n1 = vector_in(keyword.lines[1], 0, "n1");
    if (n1.norm() > 0.0) own.n1 = n1;
  }
  return own;
}

// n1 of an element along t, from the node behind its own if there is one.
Eigen::Vector3d direction_1(const InpDeck& deck,
                            const InpElement& e,
                            const Eigen::Vector3d& t,
                            const BeamSection& own) {
  const bool named = e.nodes.size() > e.type->nodes;
  const Eigen::Vector3d n1 =
      named ? Eigen::Vector3d(deck.node(e.nodes.back(), e.place).at -
                              deck.node(e.nodes.front(), e.place).at)
            : own.n1;
  constexpr double least = 1e-6;  // sine of the angle between them
  if (!(t.cross(n1).norm() > least * t.norm() * n1.norm())) {
    fail_at(e.place,
            fmt::format("element {}: its direction 1 ({:g}, {:g}, {:g}) lies "
                        "along the beam, or the beam has no length",
                        e.id,
                        n1.x(),
                        n1.y(),
                        n1.z()),
            "Give another direction in the line below the dimensions of the "
            "section.");
  }
  return n1;
}

// A bar from one node of the element to the next, by its place in the line.
void write_bar(InpDeck& deck,
               const InpElement& e,
               int id,
               std::size_t from,
               const BeamSection& own) {
  const Eigen::Vector3d t = deck.node(e.nodes[from + 1], e.place).at -
                            deck.node(e.nodes[from], e.place).at;
  const Eigen::Vector3d n1 = direction_1(deck, e, t, own);
  const Eigen::Vector2d& axis = own.shape.axis;
  CardFields fields{id, e.property, e.nodes[from], e.nodes[from + 1]};
  add_vector(fields, own.shape.upright ? t.normalized().cross(n1) : n1);
  const bool off = !axis.isZero(0.0);
  fields.emplace_back(off ? "BOO" : "BGG");
  if (off) {
    fields.resize(10);
    for (int end = 0; end < 2; ++end) {
      fields.emplace_back();
      fields.emplace_back(own.shape.upright ? axis.y() : axis.x());
      fields.emplace_back(own.shape.upright ? -axis.x() : axis.y());
    }
  }
  deck.cards.card(e.place, "CBEAM", fields);
}

void write_beam_section(InpDeck& deck, const Keyword& keyword) {
  const BeamSection own = section_of(keyword);
  const bool moduli =
      keyword.name == "BEAMGENERALSECTION" && !keyword.has("MATERIAL");
  const int material =
      moduli
          ? own_material(deck, keyword)
          : material_card(
                deck, keyword.needed_option("MATERIAL"), "MAT1", keyword.place);
  const auto elements = section_elements(deck, keyword, {InpFamily::Beam});
  const std::string card = own.shape.type.empty() ? "PBEAM" : "PBEAML";
  const int id = take_elements(deck, keyword, elements, card);
  CardFields fields{id, material};
  if (card == "PBEAML") {
    fields.insert(fields.end(), {"", own.shape.type, "", "", "", ""});
  }
  fields.insert(
      fields.end(), own.shape.numbers.begin(), own.shape.numbers.end());
  deck.cards.card(keyword.lines.front().place, card, fields);
  for (const std::size_t k : elements) {
    const InpElement& e = deck.elements[k];
    write_bar(deck, e, e.id, 0, own);
    if (e.type->nodes == 3) write_bar(deck, e, deck.next_element++, 1, own);
  }
}

}  // namespace

void write_beam_sections(InpDeck& deck) {
  for (const char* name : {"BEAMSECTION", "BEAMGENERALSECTION"}) {
    for (const Keyword* keyword : deck.of(name)) {
      write_beam_section(deck, *keyword);
    }
  }
}

}  // namespace tapfit::structure
