// Element types of Abaqus and CalculiX that are read, and their order of nodes.
//
// Source: Abaqus Elements Guide, "Node ordering and face numbering on
// elements"; CalculiX CrunchiX User's Manual, "Element types"; MSC Nastran
// Quick Reference Guide, CHEXA, CPENTA, CTETRA, CPYRAM, CQUAD8, CTRIA6.
#pragma once

#include <string>
#include <vector>

namespace tapfit::structure {

enum class InpFamily {
  Solid,
  Shell,
  Membrane,
  Beam,
  Truss,
  Mass,
  RotaryInertia,
  Spring,
  Dashpot,
  Distributing  ///< the node that others lead by their mean
};

struct InpType {
  InpFamily family;
  std::size_t nodes;    ///< on its data lines
  std::size_t corners;  ///< the first ones
  const char* card;     ///< of bulk data
  const char* names;    ///< of the types, between blanks: "C3D8 C3D8R"

  /// Which node (from 0) the card's grid `k` (from 0) is.
  [[nodiscard]] std::size_t node_of_grid(std::size_t k) const;
};

/// @param name in capitals, "C3D8R"
/// @return nullptr for a type that is not read
[[nodiscard]] const InpType* inp_type(const std::string& name);

/// Nodes of a face: corners, then those in the middle of its sides, if any.
/// @param face from 1 on, S1 of Abaqus; of shells any
/// @return positions in the element's data line; empty for no face
[[nodiscard]] std::vector<std::size_t> inp_face(const InpType& type, int face);

}  // namespace tapfit::structure
