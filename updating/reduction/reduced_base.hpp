// The room updating/reduction. The base model solved once and made small, good
// for all effects that are to be tried.
// In:  Deck, uncertain properties, stiffness changes, points.
// Out: ReducedBase: K, M and their parts in a few hundred coordinates, and how
//      far FRFs through it are off.
// May include: its row in CONTRIBUTING.md.
//
// The base model, solved once and made small.
//
//   K_r = V' K V,  M_r = V' M V = I
//
// V holds the modes to well above the band and, for every point that is
// measured, hit or acted on, the static response to a unit force with its first
// dynamic corrections. Where a support or a joint may give way, V also holds
// the answer to each degree of freedom that is released (constraint modes);
// where elements may soften, what that makes of the modes. Everything between
// rigid and very soft then lies in its span.
// Source: R. R. Craig, A. J. Kurdila, "Fundamentals of Structural Dynamics",
// 2006, ch. 17 (residual flexibility, constraint modes);
// U. Kirsch, "Reanalysis of Structures", 2008 (combined approximations).
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/progress.hpp"
#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/base_matrices.hpp"
#include "updating/reduction/base_options.hpp"
#include "updating/reduction/stiffness_change.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace tapfit::updating {

class MadeBases;

/// Holds the factored matrices, so that bases for other points cost only
/// back-substitutions.
class BaseBuilder {
 public:
  /// @throws InputError when the deck cannot be solved or an uncertain
  ///   property is none of the deck's
  BaseBuilder(const structure::Deck& deck,
              const std::vector<acquisition::UncertainProperty>& uncertain,
              const BaseOptions& options,
              const Progress& progress);
  ~BaseBuilder();
  BaseBuilder(BaseBuilder&&) noexcept;
  BaseBuilder& operator=(BaseBuilder&&) noexcept;

  /// The same test of another deck with the same grids, on its own mesh; kept
  /// nowhere.
  /// @throws InputError as the constructor
  [[nodiscard]] BaseBuilder for_deck(const structure::Deck& deck) const;

  /// Another deck with the same grids as far as this one's base can move, see
  /// deck_through_base.hpp.
  [[nodiscard]] ReducedBase through_base(const structure::Deck& deck) const;

  /// @param points further degrees of freedom that are acted on, ascending
  /// @param changes of the stiffness that the base must hold
  /// @param use what of the deck's own motions it holds
  [[nodiscard]] ReducedBase build(const std::vector<int>& points,
                                  const std::vector<StiffnessChange>& changes,
                                  BaseUse use = BaseUse::Scan) const;

  /// Gives the bases further factors, of what the mesh does to the modes and of
  /// forms that the deck lacks: see corrections().
  /// @param coarser the same deck, not split; call once, before build()
  std::vector<Correction> hold_corrections(const BaseBuilder& coarser,
                                           const Progress& progress = {});

  /// Whether the structure can move as a rigid body.
  [[nodiscard]] bool is_free() const;
  /// As which: of unit modal mass, at the deck's grids, 6 n_grids x count.
  [[nodiscard]] Eigen::MatrixXd rigid_modes() const;
  /// The lowest mode that is no rigid-body one [Hz]; infinite where it lies
  /// beyond what was solved for.
  [[nodiscard]] double elastic_hz() const;
  [[nodiscard]] double mass_kg() const;
  [[nodiscard]] const std::vector<PartMass>& part_masses() const;
  /// Largest relative error of FRFs through the base over the band, see
  /// base_error(); the base grows until it is 1e-6 or less.
  [[nodiscard]] double error() const;
  [[nodiscard]] Eigen::Index dofs() const;
  /// Mechanisms of the deck, named. Of a deck that was split none: the builder
  /// that is not names them by its own grids.
  [[nodiscard]] const std::vector<std::string>& warnings() const;

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;  // bases make rows again by it
  std::unique_ptr<MadeBases> made_;
};

}  // namespace tapfit::updating
