#include "updating/structure/abaqus/element_types.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <sstream>

namespace tapfit::structure {
namespace {

using enum InpFamily;

constexpr std::array types{
    InpType{Solid, 4, 4, "CTETRA", "C3D4 C3D4H"},
    InpType{Solid, 5, 5, "CPYRAM", "C3D5 C3D5H"},
    InpType{Solid, 6, 6, "CPENTA", "C3D6 C3D6H"},
    InpType{Solid, 8, 8, "CHEXA", "C3D8 C3D8R C3D8I C3D8H C3D8RH C3D8IH"},
    InpType{Solid,
            10,
            4,
            "CTETRA",
            "C3D10 C3D10M C3D10H C3D10MH C3D10I C3D10HS C3D10T"},
    InpType{Solid, 15, 6, "CPENTA", "C3D15 C3D15H"},
    InpType{Solid, 20, 8, "CHEXA", "C3D20 C3D20R C3D20H C3D20RH C3D20RI"},
    InpType{Shell, 3, 3, "CTRIA3", "S3 S3R STRI3 S3RS"},
    InpType{Shell, 4, 4, "CQUAD4", "S4 S4R S4R5 S4RS S4RSW"},
    InpType{Shell, 6, 3, "CTRIA6", "S6 STRI65"},
    InpType{Shell, 8, 4, "CQUAD8", "S8 S8R S8R5"},
    InpType{Membrane, 3, 3, "CTRIA3", "M3D3"},
    InpType{Membrane, 4, 4, "CQUAD4", "M3D4 M3D4R"},
    InpType{Membrane, 6, 3, "CTRIA6", "M3D6"},
    InpType{Membrane, 8, 4, "CQUAD8", "M3D8 M3D8R"},
    InpType{Beam, 2, 2, "CBEAM", "B31 B31R B31H PIPE31"},
    InpType{Beam, 3, 2, "CBEAM", "B32 B32R B32H PIPE32"},
    InpType{Truss, 2, 2, "CROD", "T3D2 T3D2H"},
    InpType{Truss, 3, 2, "CROD", "T3D3 T3D3H"},
    InpType{Mass, 1, 1, "CONM2", "MASS"},
    InpType{RotaryInertia, 1, 1, "CONM2", "ROTARYI"},
    InpType{Spring, 1, 1, "CELAS2", "SPRING1"},
    InpType{Spring, 2, 2, "CELAS2", "SPRING2"},
    InpType{Spring, 2, 2, "CBUSH1D", "SPRINGA"},
    InpType{Dashpot, 1, 1, "CDAMP2", "DASHPOT1"},
    InpType{Dashpot, 2, 2, "CDAMP2", "DASHPOT2"},
    InpType{Dashpot, 2, 2, "CBUSH1D", "DASHPOTA"},
    InpType{Distributing, 1, 1, "MPC", "DCOUP3D"}};

using Positions = std::vector<std::size_t>;

// Corners of the faces, nodes counted from 1.
const std::vector<Positions>& faces_of(std::size_t corners) {
  static const std::map<std::size_t, std::vector<Positions>> faces{
      {4, {{1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}}},
      {6, {{1, 2, 3}, {4, 6, 5}, {1, 4, 5, 2}, {2, 5, 6, 3}, {3, 6, 4, 1}}},
      {8,
       {{1, 2, 3, 4},
        {5, 8, 7, 6},
        {1, 5, 6, 2},
        {2, 6, 7, 3},
        {3, 7, 8, 4},
        {4, 8, 5, 1}}}};
  static const std::vector<Positions> none;
  const auto found = faces.find(corners);
  return found == faces.end() ? none : found->second;
}

// Corners around the bottom of a solid.
std::size_t ring_of(std::size_t corners) {
  return corners == 4 ? 3 : corners / 2;
}

// The node in the middle between two corners of a quadratic solid, all from 1:
// around the bottom, around the top, then upright.
std::size_t middle_of(std::size_t corners, std::size_t a, std::size_t b) {
  const std::size_t ring = ring_of(corners);
  const auto [low, high] = std::minmax(a, b);
  if (corners == 4 && high == 4) return corners + ring + low;
  if (high - low == ring) return corners + 2 * ring + low;
  const std::size_t level = low > ring ? ring : 0;
  const bool closes = high - low == ring - 1;
  return corners + (closes ? level + ring : low);
}

}  // namespace

std::size_t InpType::node_of_grid(std::size_t k) const {
  const std::size_t ring = ring_of(corners);
  // Bulk data has the upright edges before those around the top.
  if (family != Solid || nodes != corners + 3 * ring || k < corners + ring) {
    return k;
  }
  return k < corners + 2 * ring ? k + ring : k - ring;
}

const InpType* inp_type(const std::string& name) {
  static const std::map<std::string, const InpType*> by_name = [] {
    std::map<std::string, const InpType*> all;
    for (const InpType& type : types) {
      std::istringstream names(type.names);
      for (std::string one; names >> one;) all[one] = &type;
    }
    return all;
  }();
  const auto found = by_name.find(name);
  return found == by_name.end() ? nullptr : found->second;
}

std::vector<std::size_t> inp_face(const InpType& type, int face) {
  if (type.family == Shell || type.family == Membrane) {
    Positions all(type.nodes);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  const std::vector<Positions>& faces = faces_of(type.corners);
  if (type.family != Solid || face < 1 ||
      face > static_cast<int>(faces.size())) {
    return {};
  }
  Positions nodes = faces[static_cast<std::size_t>(face) - 1];
  const std::size_t corners = nodes.size();
  for (std::size_t k = 0; type.nodes > type.corners && k < corners; ++k) {
    nodes.push_back(
        middle_of(type.corners, nodes[k], nodes[(k + 1) % corners]));
  }
  for (std::size_t& node : nodes) --node;
  return nodes;
}

}  // namespace tapfit::structure
