// The structure that a virtual test is made on: a finer mesh than the
// engineer's, with what is hidden built into its matrices, reduced for exact
// integration in time.
//
//   q: modes of the changed structure to several times the band, and the
//   static answers to every hammer, sensor and dashpot made orthogonal to them
//   M = I,   K = diag(w^2),   C = diag(2 zeta w) + sum of c phi phi'
//
// The eigenproblem is solved for the changed structure itself; none of the
// program's own reanalysis is in it. Damping scatters from mode to mode.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "acquisition/foundation/seeded_random.hpp"
#include "acquisition/simulator/exact_response.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/elements/dashpots.hpp"
#include "updating/structure/solve/free_motions.hpp"
#include "updating/virtual_test/virtual_effect.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// The same structure twice: as the engineer has it and as it is.
struct VirtualModel {
  structure::Deck model;
  structure::Deck fine;  ///< grids of the model keep their ids
  std::map<int, std::vector<int>> children;  ///< model element -> fine ones
};

struct VirtualDamping {
  double mean = 0.006;       ///< of the elastic modes
  double scatter = 0.25;     ///< standard deviation of its logarithm
  double suspension = 0.05;  ///< of a hanging structure's rigid modes
  std::uint64_t seed = 1;
};

/// A sensor waxed to a point.
struct VirtualSensor {
  std::string channel;
  Dof dof;
};

/// A spring to ground whose force grows with the cube of its stretch: no
/// effect of a linear model.
struct HardeningSpring {
  int dof = 0;             ///< index into K and M
  double stiffness = 0.0;  ///< [N/m^3]
};

/// Matrices of the structure with all that does not move with the sensors.
struct VirtualStructure {
  structure::SparseMatrix K;  ///< over all dofs, absorbers after the deck's
  structure::SparseMatrix M;
  structure::FreeMotions motions;      ///< of all dofs
  std::map<int, int> grid_index;       ///< grid id -> position in the deck
  std::vector<VirtualEffect> effects;  ///< all of them, as given
  std::vector<structure::Dashpot> dashpots;
  std::optional<HardeningSpring> hardening;
  std::vector<int> support_nodes;  ///< of the model, where it gives way
  double support_length = 0.0;     ///< [m]
  double total_mass = 0.0;         ///< of the structure alone [kg]
  double suspension_hz = 0.0;      ///< 0: supported

  /// Index into K and M; the sign of the direction is left to the caller.
  /// @throws InputError for a grid that does not exist
  [[nodiscard]] int dof_index(const Dof& dof) const;
};

/// Builds everything in but the sensors.
///
/// @param modulus_factor true over nominal E of the first material
/// @param component 1..3, the direction that is tested: effects at a grid act
///   in it
/// @throws InputError for an effect at a place that does not exist, a
///   `soft-support` on a structure whose held grids form no line along an
///   axis, a `joint` where nothing can turn
[[nodiscard]] VirtualStructure build_virtual_structure(
    const VirtualModel& model,
    const std::vector<VirtualEffect>& effects,
    double modulus_factor,
    int component);

/// The structure with the sensors of one run on it, in few coordinates.
struct ReducedTruth {
  acquisition::SecondOrderSystem system;  ///< input: the first hammer's
  Eigen::MatrixXd hammers;                ///< r x hammers
  Eigen::VectorXd frequency_hz;           ///< poles up to max_hz, ascending
  Eigen::VectorXd damping_ratio;
};

/// @param hammers points that are hit with the sensors where they are
/// @param max_hz modes are taken up to here [Hz]
[[nodiscard]] ReducedTruth reduce_truth(
    const VirtualStructure& structure,
    const std::vector<VirtualSensor>& sensors,
    const std::vector<Dof>& hammers,
    double max_hz,
    const VirtualDamping& damping);

}  // namespace tapfit::updating
