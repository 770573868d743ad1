// The room updating/corrections. What a careful engineer's deck is off by with
// nothing missing: its mesh, and forms that it lacks.
// In:  Deck and its split one, their matrices and modes.
// Out: factors with their priors, and the K and M that each scales.
// May include: its row in CONTRIBUTING.md.
//
// What an engineer's model is off by without anything missing, as factors that
// are fitted along with what is uncertain:
//
//   K(f) = K + sum_k (f_k - 1) K_k,   M(f) = M + sum_k (f_k - 1) M_k
//
// "mesh size" scales all that changed when the mesh was split (mesh_shift()): 1
// is the split mesh; where the error falls with the square of the element, 4/3
// is the limit of ever finer ones (Richardson's extrapolation). "mesh edges",
// where shells have free edges, is one more than the share of the edges' layer
// that the mesh lacks (free_edge_layer()). The others are forms that the deck
// lacks (deck_forms.hpp): at 1 it is the deck as it stands, at 2 the deck with
// it.
#pragma once

#include "updating/corrections/correction.hpp"
#include "updating/corrections/mass_forms.hpp"
#include "updating/corrections/mesh_shift.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct CorrectionPart {
  Correction correction;
  Eigen::MatrixXd K;  ///< r x r, in the base's coordinates
  Eigen::MatrixXd M;
  /// By which it acts on vectors outside the base, dofs square; 0 x 0: not.
  structure::SparseMatrix beyond = {};
};

/// The modes of the split deck with a form that it lacks.
struct FormModes {
  Correction correction;
  MeshModes modes;
};

/// The modes that corrections are taken from, at the deck's own grids.
struct CorrectedModes {
  MeshModes split;    ///< the base's first vectors
  MeshModes unsplit;  ///< of the deck's own elements
  std::vector<FormModes> forms = {};
};

/// @param deck the split one
/// @param V dofs x r, the split modes first
/// @param mass with the modes of the deck with all of them in V
/// @return the mesh's first, those of mass last
[[nodiscard]] std::vector<CorrectionPart> corrections(
    const structure::Deck& deck,
    const Eigen::MatrixXd& V,
    const CorrectedModes& modes,
    const std::vector<MassForm>& mass);

}  // namespace tapfit::updating
