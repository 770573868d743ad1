// The base model's matrices with degrees of freedom more than it has: supports
// released, joints cut. What holds them are springs, one matrix per change.
//
// A joint adds one rotation q_n per grid of its line, by which the elements on
// one side turn against the grid; a crack adds three displacements and two
// rotations. With T (dofs x motions) their directions and K_B the stiffness of
// the elements on that side,
//
//   K = [ K    K_B T       ]
//       [ sym  T' K_B T    ]        (M alike)
//
// q = 0 is the structure without the joint.
#pragma once

#include "updating/corrections/mass_forms.hpp"
#include "updating/properties/element_parts.hpp"
#include "updating/reduction/stiffness_change.hpp"
#include "updating/structure/mesh/refined_deck.hpp"
#include "updating/structure/solve/bordered_matrix.hpp"
#include "updating/structure/solve/system.hpp"

#include <vector>

namespace tapfit::updating {

/// What one parameter of a change multiplies.
struct ScaledStiffness {
  std::size_t change = 0;     ///< position among the changes
  std::size_t parameter = 0;  ///< position among its effect's parameters
  structure::SparseMatrix S;  ///< d K / d p
  /// What S takes from properties; the mass in them does not go with p.
  std::vector<UncertainPart> parts = {};
  /// Of elements that are thinned, what goes with their thickness and is not in
  /// S, with as many parts (see StiffnessTerm: T and N); 0 x 0: none.
  ElementParts::Sum thickness = {};

  [[nodiscard]] bool is_thinned() const { return thickness.M.size() > 0; }
};

/// An uncertain part of the system, with what is released.
struct ReleasedPart {
  const UncertainPart* plain = nullptr;
  structure::BorderedMatrix K;
  structure::BorderedMatrix M;
};

/// A form of mass that it lacks, with what is released.
struct ReleasedForm {
  const MassForm* plain = nullptr;
  structure::BorderedMatrix M;
};

/// Views the system's matrices, its parts and forms, which must outlive it:
/// what is released is a border of them.
struct ReleasedSystem {
  structure::BorderedMatrix K;
  structure::BorderedMatrix M;
  std::vector<ReleasedPart> parts = {};
  std::vector<ReleasedForm> forms = {};
  std::vector<ScaledStiffness> scaled = {};  ///< change after change
  std::vector<int> active = {};  ///< degrees of freedom that can move
  /// Of the system's, those that are held besides (held_motions.hpp): K and M
  /// have them as if they were free.
  std::vector<int> held = {};

  [[nodiscard]] Eigen::Index dofs() const { return K.rows(); }
};

/// Nothing released.
/// @param parts its uncertain parts, as from uncertain_parts()
/// @param forms that it lacks
[[nodiscard]] ReleasedSystem nothing_released(
    const structure::System& system,
    const std::vector<UncertainPart>& parts,
    const std::vector<MassForm>& forms = {});

/// @param mesh the deck that is solved, with what its elements were split into
/// @param system its matrices
/// @param plain the same, with nothing released
/// @param elements of the mesh
/// @param pulled how hard the modes pull at what holds each degree of freedom,
///   relative [N or N m]: where a support gives way, translations that nothing
///   pulls at stay held; empty: not known
[[nodiscard]] ReleasedSystem release(
    const structure::RefinedDeck& mesh,
    const structure::System& system,
    const ReleasedSystem& plain,
    const ElementParts& elements,
    const std::vector<StiffnessChange>& changes,
    const Eigen::VectorXd& pulled = {});

/// Lends mass (massless_dofs.hpp) to what is released and to what changes act
/// on or hold: rotations seldom have one, and the modes of a coarse mesh may
/// hold all that has.
///
/// @param free degrees of freedom of the system before, ascending
void add_regularising_mass(const std::vector<int>& free,
                           double high_hz,
                           ReleasedSystem& released);

}  // namespace tapfit::updating
