// *BEAM SECTION and *BEAM GENERAL SECTION: PBEAM and CBEAM. A beam with a node
// in its middle becomes two.
#include "updating/structure/abaqus/beam_shapes.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <array>

namespace tapfit::structure {
namespace {

struct BeamSection {
  BeamShape shape;
  Eigen::Vector3d n1{0.0, 0.0, -1.0};  // where none is given
  std::array<double, 2> off{};         // its axis from the nodes, along n1, n2
};

// E, G of *BEAM GENERAL SECTION without MATERIAL.
int own_material(InpDeck& deck, const Keyword& keyword) {
  const DataLine& line = keyword.line(2, "E, G");
  const double E = number_in(line, 0, "E");
  const double G = number_in(line, 1, "G");
  const DataLine density{{keyword.option("DENSITY")}, keyword.place, false};
  const int id = deck.next_material++;
  const std::string set = keyword.option("ELSET");
  deck.cards.comment(fmt::format("MAT1 {}: section of {}", id, set),
                     line.place);
  deck.cards.card(line.place,
                  "MAT1",
                  {fmt::format("{}", id),
                   real_field(E),
                   real_field(G),
                   "",
                   real_field(number_or(density, 0, 0.0, "DENSITY"))});
  deck.named.push_back(fmt::format("MAT1 {} is the material of {}", id, set));
  return id;
}

// What OFFSET1 and OFFSET2 say, in sizes of the section.
double shift(const Keyword& keyword, const char* option) {
  const DataLine line{{keyword.option(option)}, keyword.place, false};
  return number_or(line, 0, 0.0, option);
}

BeamSection section_of_beams(const Keyword& keyword) {
  const bool general = keyword.name == "BEAMGENERALSECTION";
  std::string type = keyword.option("SECTION");
  if (type.empty() && general) type = "GENERAL";
  if (type.empty()) static_cast<void>(keyword.needed_option("SECTION"));
  BeamSection own;
  own.shape = beam_shape(type, keyword.line(0, "dimensions"));
  own.off = {
      own.shape.centroid[0] - shift(keyword, "OFFSET1") * own.shape.size[0],
      own.shape.centroid[1] - shift(keyword, "OFFSET2") * own.shape.size[1]};
  if (keyword.lines.size() > 1) {
    const DataLine& line = keyword.lines[1];
    const Eigen::Vector3d n1(number_or(line, 0, 0.0, "n1"),
                             number_or(line, 1, 0.0, "n1"),
                             number_or(line, 2, 0.0, "n1"));
    if (n1.norm() > 0.0) own.n1 = n1;
  }
  return own;
}

void write_property(InpDeck& deck,
                    const Keyword& keyword,
                    int id,
                    int material,
                    const BeamShape& s) {
  std::vector<std::string> fields{fmt::format("{}", id),
                                  fmt::format("{}", material)};
  for (const double value : {s.area, s.I1, s.I2, s.I12, s.J}) {
    fields.push_back(real_field(value));
  }
  fields.resize(16);
  fields.push_back(real_field(s.K1));
  fields.push_back(real_field(s.K2));
  deck.cards.card(keyword.place, "PBEAM", fields);
}

void write_bar(InpDeck& deck,
               const InpElement& e,
               const std::array<int, 3>& id_and_ends,
               const BeamSection& own) {
  Eigen::Vector3d n1 = own.n1;
  const Eigen::Vector3d a = deck.node(id_and_ends[1], e.place).at;
  if (e.nodes.size() > e.type->nodes) {
    n1 = deck.node(e.nodes.back(), e.place).at - a;
  }
  const Eigen::Vector3d along = deck.node(id_and_ends[2], e.place).at - a;
  constexpr double least = 1e-6;  // sine of the angle between them
  if (!(along.cross(n1).norm() > least * along.norm() * n1.norm())) {
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
  std::vector<std::string> fields{fmt::format("{}", id_and_ends[0]),
                                  fmt::format("{}", e.property),
                                  fmt::format("{}", id_and_ends[1]),
                                  fmt::format("{}", id_and_ends[2]),
                                  real_field(n1.x()),
                                  real_field(n1.y()),
                                  real_field(n1.z())};
  const bool off = own.off[0] != 0.0 || own.off[1] != 0.0;
  fields.emplace_back(off ? "BOO" : "BGG");
  if (off) {
    fields.resize(10);
    for (int end = 0; end < 2; ++end) {
      fields.emplace_back();
      fields.push_back(real_field(own.off[0]));
      fields.push_back(real_field(own.off[1]));
    }
  }
  deck.cards.card(e.place, "CBEAM", fields);
}

void write_section(InpDeck& deck, const Keyword& keyword) {
  const std::string set = keyword.needed_option("ELSET");
  const bool own_moduli =
      keyword.name == "BEAMGENERALSECTION" && !keyword.has("MATERIAL");
  const BeamSection own = section_of_beams(keyword);
  const int material =
      own_moduli
          ? own_material(deck, keyword)
          : material_card(
                deck, keyword.needed_option("MATERIAL"), "MAT1", keyword.place);
  const int id = deck.next_property++;
  deck.cards.comment(fmt::format("PBEAM {}: *{} of {}", id, keyword.shown, set),
                     keyword.place);
  deck.named.push_back(fmt::format("PBEAM {} is {}", id, set));
  write_property(deck, keyword, id, material, own.shape);
  for (const std::size_t k : deck.elements_of(set, keyword.place)) {
    InpElement& e = deck.elements[k];
    if (e.type == nullptr || e.type->family != InpFamily::Beam) continue;
    e.property = id;
    if (e.type->nodes == 2) {
      write_bar(deck, e, {e.id, e.nodes[0], e.nodes[1]}, own);
      continue;
    }
    write_bar(deck, e, {e.id, e.nodes[0], e.nodes[1]}, own);
    write_bar(deck, e, {deck.next_element++, e.nodes[1], e.nodes[2]}, own);
  }
}

}  // namespace

void write_beam_sections(InpDeck& deck) {
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step != 0) break;
    if (keyword.name == "BEAMSECTION" || keyword.name == "BEAMGENERALSECTION") {
      write_section(deck, keyword);
    }
  }
}

}  // namespace tapfit::structure
