#include "updating/structure/abaqus/element_types.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace tapfit::structure {
namespace {

using Positions = std::vector<std::size_t>;

Positions as_they_are(std::size_t count) {
  Positions order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

InpType plain(InpFamily family,
              std::size_t nodes,
              std::size_t corners,
              const char* card) {
  return {family, nodes, corners, card, as_they_are(nodes)};
}

// Abaqus numbers the middle nodes of the edges at the bottom, at the top, then
// the upright ones; bulk data bottom, upright, top.
InpType uprights_second(std::size_t corners, const char* card) {
  const std::size_t ring = corners / 2;
  InpType type = plain(InpFamily::Solid, corners + 3 * ring, corners, card);
  std::rotate(
      type.order.begin() + static_cast<std::ptrdiff_t>(corners + ring),
      type.order.begin() + static_cast<std::ptrdiff_t>(corners + 2 * ring),
      type.order.end());
  return type;
}

using Types = std::map<std::string, InpType>;

void add(Types& types,
         const std::vector<const char*>& names,
         const InpType& type) {
  for (const char* name : names) types.emplace(name, type);
}

Types solid_types() {
  using enum InpFamily;
  Types types;
  add(types, {"C3D4", "C3D4H"}, plain(Solid, 4, 4, "CTETRA"));
  add(types, {"C3D5", "C3D5H"}, plain(Solid, 5, 5, "CPYRAM"));
  add(types, {"C3D6", "C3D6H"}, plain(Solid, 6, 6, "CPENTA"));
  add(types,
      {"C3D8", "C3D8R", "C3D8I", "C3D8H", "C3D8RH", "C3D8IH"},
      plain(Solid, 8, 8, "CHEXA"));
  add(types,
      {"C3D10", "C3D10M", "C3D10H", "C3D10MH", "C3D10I", "C3D10HS", "C3D10T"},
      plain(Solid, 10, 4, "CTETRA"));
  add(types, {"C3D15", "C3D15H"}, uprights_second(6, "CPENTA"));
  add(types,
      {"C3D20", "C3D20R", "C3D20H", "C3D20RH", "C3D20RI"},
      uprights_second(8, "CHEXA"));
  return types;
}

Types all_types() {
  using enum InpFamily;
  Types types = solid_types();
  add(types, {"S3", "S3R", "STRI3", "S3RS"}, plain(Shell, 3, 3, "CTRIA3"));
  add(types,
      {"S4", "S4R", "S4R5", "S4RS", "S4RSW"},
      plain(Shell, 4, 4, "CQUAD4"));
  add(types, {"S6", "STRI65"}, plain(Shell, 6, 3, "CTRIA6"));
  add(types, {"S8", "S8R", "S8R5"}, plain(Shell, 8, 4, "CQUAD8"));
  add(types, {"M3D3"}, plain(Membrane, 3, 3, "CTRIA3"));
  add(types, {"M3D4", "M3D4R"}, plain(Membrane, 4, 4, "CQUAD4"));
  add(types, {"M3D6"}, plain(Membrane, 6, 3, "CTRIA6"));
  add(types, {"M3D8", "M3D8R"}, plain(Membrane, 8, 4, "CQUAD8"));
  add(types, {"B31", "B31R", "B31H", "PIPE31"}, plain(Beam, 2, 2, "CBEAM"));
  add(types, {"B32", "B32R", "B32H", "PIPE32"}, plain(Beam, 3, 2, "CBEAM"));
  add(types, {"T3D2", "T3D2H"}, plain(Truss, 2, 2, "CROD"));
  add(types, {"T3D3", "T3D3H"}, plain(Truss, 3, 2, "CROD"));
  add(types, {"MASS"}, plain(Mass, 1, 1, "CONM2"));
  add(types, {"ROTARYI"}, plain(RotaryInertia, 1, 1, "CONM2"));
  add(types, {"SPRING1"}, plain(Spring, 1, 1, "CELAS2"));
  add(types, {"SPRING2"}, plain(Spring, 2, 2, "CELAS2"));
  add(types, {"SPRINGA"}, plain(Spring, 2, 2, "CBUSH1D"));
  add(types, {"DASHPOT1"}, plain(Dashpot, 1, 1, "CDAMP2"));
  add(types, {"DASHPOT2"}, plain(Dashpot, 2, 2, "CDAMP2"));
  add(types, {"DASHPOTA"}, plain(Dashpot, 2, 2, "CBUSH1D"));
  return types;
}

// Corners of the faces, nodes counted from 1.
const std::vector<Positions>& faces_of(std::size_t corners) {
  static const std::vector<Positions> tetra{
      {1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}};
  static const std::vector<Positions> wedge{
      {1, 2, 3}, {4, 6, 5}, {1, 4, 5, 2}, {2, 5, 6, 3}, {3, 6, 4, 1}};
  static const std::vector<Positions> brick{{1, 2, 3, 4},
                                            {5, 8, 7, 6},
                                            {1, 5, 6, 2},
                                            {2, 6, 7, 3},
                                            {3, 7, 8, 4},
                                            {4, 8, 5, 1}};
  static const std::vector<Positions> none;
  if (corners == 4) return tetra;
  if (corners == 6) return wedge;
  return corners == 8 ? brick : none;
}

// The edges of a quadratic solid in the order of their middle nodes, corners
// from 1.
std::vector<std::array<std::size_t, 2>> edges_of(std::size_t corners) {
  if (corners == 4) {
    return {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 4}, {3, 4}};
  }
  std::vector<std::array<std::size_t, 2>> edges;
  const std::size_t ring = corners / 2;
  for (const std::size_t level : {std::size_t{0}, ring}) {
    for (std::size_t k = 0; k < ring; ++k) {
      edges.push_back({level + k + 1, level + (k + 1) % ring + 1});
    }
  }
  for (std::size_t k = 1; k <= ring; ++k) edges.push_back({k, k + ring});
  return edges;
}

}  // namespace

const InpType* inp_type(const std::string& name) {
  static const Types types = all_types();
  const auto found = types.find(name);
  return found == types.end() ? nullptr : &found->second;
}

std::vector<std::size_t> inp_face(const InpType& type, int face) {
  if (type.family == InpFamily::Shell || type.family == InpFamily::Membrane) {
    return as_they_are(type.nodes);
  }
  const std::vector<Positions>& faces = faces_of(type.corners);
  if (type.family != InpFamily::Solid || face < 1 ||
      face > static_cast<int>(faces.size())) {
    return {};
  }
  Positions nodes = faces[static_cast<std::size_t>(face) - 1];
  const std::size_t corners = nodes.size();
  if (type.nodes > type.corners) {
    const auto edges = edges_of(type.corners);
    for (std::size_t k = 0; k < corners; ++k) {
      const std::size_t a = nodes[k];
      const std::size_t b = nodes[(k + 1) % corners];
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const bool same = (edges[e][0] == a && edges[e][1] == b) ||
                          (edges[e][0] == b && edges[e][1] == a);
        if (same) nodes.push_back(type.corners + e + 1);
      }
    }
  }
  for (std::size_t& node : nodes) --node;
  return nodes;
}

}  // namespace tapfit::structure
