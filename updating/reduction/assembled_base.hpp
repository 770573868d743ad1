// A deck, its elements split, as matrices: what a reduced base is made of.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/progress.hpp"
#include "updating/corrections/corrections.hpp"
#include "updating/reduction/base_options.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/reduction/residual_flexibility.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/mesh/refined_deck.hpp"
#include "updating/structure/solve/free_motions.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

#include <optional>
#include <stop_token>
#include <vector>

namespace tapfit::updating {

struct AssembledBase {
  /// @throws InputError for a deck that nothing moves in, without mass, or
  ///   without an uncertain property that is named
  AssembledBase(const structure::Deck& deck,
                const std::vector<acquisition::UncertainProperty>& properties,
                const BaseOptions& wanted,
                const Progress& progress);
  // The answers refer to the matrices.
  AssembledBase(const AssembledBase&) = delete;
  AssembledBase& operator=(const AssembledBase&) = delete;

  BaseOptions options;  ///< with the deck's dampers among the points
  std::vector<acquisition::UncertainProperty> uncertain;
  Eigen::Index original_grids = 0;
  structure::RefinedDeck mesh;  ///< the deck, split
  structure::System system;
  structure::FreeMotions motions;   ///< u = T q
  double mass = 0.0;                ///< [kg]
  std::vector<PartMass> part_mass;  ///< of those with mass
  double shift = 0.0;  ///< K + shift M gives static answers [rad^2/s^2]
  std::optional<ResidualFlexibility> answers;
  std::vector<UncertainPart> parts;
  std::vector<MassForm> forms;  ///< of mass that it lacks
  ReleasedSystem plain;         ///< the model with nothing released
  ElementParts elements;        ///< of the mesh
};

/// Modes of the other forms that the deck lacks, on the same mesh, at its own
/// grids.
[[nodiscard]] std::vector<FormModes> form_modes(const AssembledBase& model,
                                                const std::stop_token& stop);

}  // namespace tapfit::updating
