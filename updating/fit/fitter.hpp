// The room updating/fit. Parameters identified from FRFs.
// In:  FrfModel, measured FRFs on damped lines, priors.
// Out: Fit: the parameters, their uncertainty, the error that is left, and how
//      it came about.
// May include: its row in CONTRIBUTING.md.
//
// Fits the base model with any set of effects to the measured FRFs, from wide
// damped lines to the one on which models are compared.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "modal/checks/run_poles.hpp"
#include "updating/fit/known_mass.hpp"
#include "updating/fit/updater.hpp"
#include "updating/frf_model/acted_points.hpp"
#include "updating/frf_model/form_error.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/residual/residual.hpp"

#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// Everything that fits of one test share. The targets are ordered from the
/// widest line to the one that counts.
struct FitProblem {
  effects::TestContext context;
  std::vector<Target> targets;
  std::vector<modal::ForeignRun> foreign = {};  ///< not in use in any target
  signal::FrfSet measured;                      ///< on the last target's line
  /// In place of FRFs, or null: then there is one target.
  std::shared_ptr<const ModalData> modes = nullptr;
  std::string contour;               ///< the last target's line, in words
  std::vector<double> uncertain_sd;  ///< of ln factor
  std::vector<Correction> corrections = {};  ///< the last of these
  double damping_ratio = 0.01;               ///< typical, as identified
  double damping_spread = 0.5;               ///< prior sd of ln zeta
  double form_allowance = 1.0;               ///< see FormView
  std::optional<KnownMass> weighed = {};
};

struct Fit {
  std::vector<EffectInstance> effects;
  UpdateResult result;
  std::shared_ptr<const FrfModel> model;
  int stopped_after = 0;  ///< steps, where it was ended by hand, else 0
  FormView form = {};     ///< what it leaves, as the deck's form sees it
  /// Of what it leaves, see FormEstimate.
  double log_likelihood = 0.0;
};

/// The effect's parameters with the ranges and starts that the model's base
/// gives those that change its stiffness.
[[nodiscard]] std::vector<effects::ParameterSpec> parameters_of(
    const EffectInstance& effect, const FrfModel& model);

class Fitter {
 public:
  Fitter(const BaseBuilder& builder, FitProblem problem);

  /// The same model under another setting: other priors, fewer runs in use.
  /// @param problem with as many uncertain properties, on the same lines
  [[nodiscard]] Fitter with(FitProblem problem) const;

  /// Model whose base holds the points and supports of all effects given.
  [[nodiscard]] std::shared_ptr<const FrfModel> model_for(
      const std::vector<EffectInstance>& effects,
      BaseUse use = BaseUse::Fit) const;

  /// With the same on the deck's own mesh, where the base's is split. For what
  /// changes the stiffness that takes a base of its own, which model_for()
  /// leaves out: a fit asks for it once it comes to the lines that count.
  [[nodiscard]] std::shared_ptr<const FrfModel> with_coarser(
      std::shared_ptr<const FrfModel> model,
      const std::vector<EffectInstance>& effects) const;

  /// Fits effects' parameters, uncertain properties and damping together. The
  /// modes beyond those fitted have the ratio that is typical of these, without
  /// what the effects add: it is taken anew as they become known.
  ///
  /// @param start effects with their starting sizes
  /// @param model as from model_for(), for these effects or more
  /// @param before a fit of the first of these effects, if there is one: where
  ///   more effects end with more error they go on from there
  [[nodiscard]] Fit fit(const std::vector<EffectInstance>& start,
                        std::shared_ptr<const FrfModel> model,
                        const Progress& progress = {},
                        const Fit* before = nullptr) const;

  /// fit() but for its end: the wide lines, then a few steps on those that
  /// count. Its likelihood is, to first order, that of the end.
  /// @param too_much error on the wide lines with which it is given up
  [[nodiscard]] std::optional<Fit> approach(
      const std::vector<EffectInstance>& start,
      std::shared_ptr<const FrfModel> model,
      const Progress& progress = {},
      double too_much = std::numeric_limits<double>::infinity()) const;

  /// The end that approach() leaves out.
  [[nodiscard]] Fit arrive(Fit approached, const Progress& progress = {}) const;

  /// Goes on from where a fit of the same effects ended, at places beside
  /// theirs: only on the lines that count.
  /// @param model as from model_for(), for the effects at these places
  [[nodiscard]] Fit fit_beside(const Fit& fit,
                               const std::vector<EffectInstance>& effects,
                               std::shared_ptr<const FrfModel> model,
                               const Progress& progress = {}) const;

  /// A fit whose error is to be told, not only compared: with the ratio of the
  /// modes beyond the band to a hundredth of it, so that fits of the same
  /// effects end at the same error to a thousandth, whichever way they came.
  /// Of modes as the measurement it stays as it is: nothing lies beyond them.
  [[nodiscard]] Fit settled(Fit fit, const Progress& progress = {}) const;

  /// Goes on from a fit with some runs left out of the last target; returns
  /// the error on those runs.
  [[nodiscard]] double held_out_error(const Fit& fit,
                                      int folds,
                                      const Progress& progress = {}) const;

  [[nodiscard]] Prior prior_for(const FrfModel& model,
                                const ModelState& state) const;
  /// Where fits start: effects as given, the newest with the best size of a
  /// scan over all that it may be.
  /// @param before a fit from whose properties it goes on; none: the deck's
  [[nodiscard]] ModelState start_state(const FrfModel& model,
                                       const std::vector<EffectInstance>& start,
                                       const Fit* before = nullptr) const;
  /// Where a fit of the first of these effects, or of all, ended, with the
  /// others at that end of their bounds where they change least: as good as not
  /// there. Nothing where it is no such fit.
  [[nodiscard]] std::optional<ModelState> continued(
      const FrfModel& model,
      const std::vector<EffectInstance>& effects,
      const Fit& before) const;
  [[nodiscard]] ModelState first_state(
      const FrfModel& model, const std::vector<EffectInstance>& effects) const;

  /// What fits need to know of the mesh's error.
  /// @param coarser the deck's own mesh, where that of the base is split
  void set_mesh(const BaseBuilder& coarser);

  /// Where an effect may be in this setting, so far as a measurement could tell
  /// places apart; worked out when first asked for.
  [[nodiscard]] const std::vector<Location>& places(
      const effects::Effect& effect) const;

  [[nodiscard]] const BaseBuilder& builder() const { return *builder_; }
  [[nodiscard]] const FitProblem& problem() const { return problem_; }
  [[nodiscard]] const Target& target() const { return problem_.targets.back(); }

 private:
  [[nodiscard]] ModelState going_on(const FrfModel& model,
                                    const std::vector<EffectInstance>& effects,
                                    const ModelState& from) const;
  [[nodiscard]] ModelState beside(const FrfModel& model,
                                  const std::vector<EffectInstance>& effects,
                                  const Fit& fit) const;
  void scan_start(const FrfModel& model, ModelState& state) const;

  [[nodiscard]] std::shared_ptr<const FrfModel> with_mesh_at_state(
      const ModelState& state, const FrfModel& before) const;
  class Course;

  const BaseBuilder* builder_;
  const BaseBuilder* coarser_ = nullptr;
  std::shared_ptr<const FrfModel> plain_coarser_;  // with no effect
  FitProblem problem_;

  struct KnownPlaces {
    std::mutex mutex;
    std::map<const effects::Effect*, std::vector<Location>> of;
  };
  std::shared_ptr<KnownPlaces> places_ = std::make_shared<KnownPlaces>();
};

}  // namespace tapfit::updating
