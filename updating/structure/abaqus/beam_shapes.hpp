// Cross sections of beams.
//
// Axis 1 is n1, axis 2 is n2 = t x n1; plane 1 of bulk data holds n1. So I1 of
// bulk data (bending in plane 1) is I22 of the deck (about axis 2).
//
// Source: Abaqus Analysis User's Guide, "Beam cross-section library" and
// "Choosing a beam element" (shear factors); CalculiX CrunchiX User's Manual,
// *BEAM SECTION, *BEAM GENERAL SECTION; W. C. Young, Roark's Formulas for
// Stress and Strain, 7th ed., table 10.1 (torsion).
#pragma once

#include "updating/structure/abaqus/keyword_block.hpp"

#include <array>

namespace tapfit::structure {

struct BeamShape {
  double area = 0.0;
  double I1 = 0.0;  ///< integral of x1^2, bending in the plane of n1
  double I2 = 0.0;  ///< integral of x2^2
  double I12 = 0.0;
  double J = 0.0;
  double K1 = 1.0;  ///< shear factors along n1, n2
  double K2 = 1.0;
  /// Its centroid from the nodes, along n1 and n2.
  std::array<double, 2> centroid{};
  std::array<double, 2> size{};  ///< along n1 and n2, the unit of offsets
};

/// @param type SECTION in capitals: RECT, CIRC, PIPE, BOX, I, GENERAL
/// @param line its dimensions
/// @throws InputError for another type, a missing dimension, one below zero
[[nodiscard]] BeamShape beam_shape(const std::string& type,
                                   const DataLine& line);

}  // namespace tapfit::structure
