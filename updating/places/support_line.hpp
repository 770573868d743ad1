// The geometry of a support: along which line its grids lie, and how much of
// its length each carries.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::updating {

/// A released degree of freedom of a support and the length it carries.
struct SupportDof {
  int node = 0;
  int component = 0;      ///< 1..6, along basic axes
  double length = 0.0;    ///< [m]; 1 / number of grids where they are apart
  double at = 0.0;        ///< 0 to 1 along the line; 0 where there is none
  bool own_axes = false;  ///< component along the grid's own (turned) axes
  int with = 0;           ///< component of the grid that it is coupled with
};

struct SupportLine {
  std::vector<SupportDof> dofs;
  double length = 0.0;    ///< total [m]; 1 for each place of grids apart
  bool straight = false;  ///< whether there is a line
};

/// The degrees of freedom that a soft support releases: for grids along a line
/// parallel to an axis, and along held edges that are all parallel to axes, the
/// rotation about these, otherwise all three rotations; for translations all
/// three. The feet of a frame, and edges that are not joined and lie on no line
/// together, are each taken by themselves.
///
/// @param nodes constrained grids of the deck, in any order
/// @param rotation true: rotations, false: translations
/// @return only degrees of freedom that the deck holds along basic axes; none
/// of
///   grids that are held along turned axes (see constraint_axes.hpp)
[[nodiscard]] SupportLine support_line(const structure::Deck& deck,
                                       const std::vector<int>& nodes,
                                       bool rotation);

enum class SupportMotion { Rotation, Translation, Face };

/// What one stiffness of a support holds.
struct SupportPart {
  SupportMotion motion = SupportMotion::Rotation;
  int end = 0;       ///< grid at whose end of the line it is the stiffness; 0:
                     ///< all along
  SupportLine line;  ///< lengths times this stiffness' share in each; of a
                     ///< face [m^2, m^3, m^4] of one per area
  double turn =
      0.0;  ///< of a face about its edges, else where it is least [m^4]
};

/// The stiffnesses of a soft support: "rotation" and "translation" have one
/// each, "both" has these two. "rotation-varying" and "translation-varying"
/// run linearly along the line, from the stiffness at its first end (of the
/// smallest coordinate) to that at its last. "face" is one per area of the face
/// (support_face.hpp).
///
/// @return none where the support does not hold what the variant asks for, or
///   where there is no line to vary along
///
/// One of freed_variants() has one stiffness for all that is held in these
/// components, whatever the line. Of grids held along turned axes those that
/// free all translations or all rotations free what is held of them.
[[nodiscard]] std::vector<SupportPart> support_parts(
    const structure::Deck& deck,
    const std::vector<int>& nodes,
    const std::string& variant);

/// What a support may not hold at all: "free", "free-rotations", "free-X",
/// "free-Y", "free-Z".
[[nodiscard]] std::vector<std::string> freed_variants();

/// What one of these frees, digits of 1..6 along basic axes: "456"; empty for
/// other variants.
[[nodiscard]] std::string freed_components(const std::string& variant);

}  // namespace tapfit::updating
