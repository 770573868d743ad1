// Cross sections of beams as those of PBEAML and PBEAM.
//
// Axis 1 is n1, axis 2 is n2 = t x n1; plane 1 of bulk data holds n1, or n2 of
// a section whose height lies along it. So I1 of a PBEAM (bending in plane 1)
// is I22 of the deck (about axis 2).
//
// Source: Abaqus Analysis User's Guide, "Beam cross-section library"; CalculiX
// CrunchiX User's Manual, *BEAM SECTION, *BEAM GENERAL SECTION; MSC Nastran
// Quick Reference Guide, PBEAML, PBEAM.
#pragma once

#include "updating/structure/abaqus/card_lines.hpp"

#include <Eigen/Core>

namespace tapfit::structure {

struct BeamShape {
  std::string type;      ///< of PBEAML: "BAR"; "" for a PBEAM
  CardFields numbers;    ///< its dimensions; A, I1, I2, I12, J of a PBEAM
  bool upright = false;  ///< plane 1 holds n2
  /// The bar's axis (its shear centre) from the nodes, along n1 and n2.
  Eigen::Vector2d axis = Eigen::Vector2d::Zero();
  /// Along n1 and n2, the unit of offsets.
  Eigen::Vector2d size = Eigen::Vector2d::Zero();
};

/// Whether dimensions give a section is left to the reader of the card.
///
/// @param type SECTION in capitals: RECT, CIRC, PIPE, BOX, I, GENERAL
/// @param line its dimensions
/// @throws InputError for another type, a missing dimension
[[nodiscard]] BeamShape beam_shape(const std::string& type,
                                   const DataLine& line);

}  // namespace tapfit::structure
