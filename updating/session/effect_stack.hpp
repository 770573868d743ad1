// The effects that were added to the base model, one after the other: each can
// be switched off and on, and every change undone and done again.
#pragma once

#include "updating/effects/effect_ref.hpp"
#include "updating/fit/early_stopped_fit.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/session/added_effect.hpp"

#include <functional>
#include <vector>

namespace tapfit::updating {

/// How the effects of a stack are placed and fitted.
struct StackFit {
  effects::TestContext context;
  /// Fit of these effects with everything else that is uncertain, after the fit
  /// of those before the last.
  std::function<Fit(
      const std::vector<EffectInstance>&, const Fit& before, const Progress&)>
      fit;
};

/// The effects that are added, and how that came about.
struct EffectHistory {
  using Effects = std::vector<AddedEffect>;

  Effects now;
  std::vector<Effects> past;  ///< what an undo goes back to, the next one last
  std::vector<Effects> future;  ///< what a redo goes on to, the next one last
  /// Fits of any of these that were ended by hand; made again, they end there.
  std::vector<EarlyStoppedFit> kept = {};
};

/// Fits of the base model with ever more of the effects. A change that fails
/// or is stopped leaves everything as it was.
class EffectStack {
 public:
  /// @param base the deck as it is, nothing fitted
  /// @param uncertain whether the model has properties to be fitted: they are
  ///   a rung of their own, since what they alone can do is no merit of the
  ///   first effect
  EffectStack(Fit base, bool uncertain);

  /// Fits what is uncertain in the model with no effect added.
  void fit_uncertain(const StackFit& how, const Progress& progress);
  /// As add_together() of one.
  void add(const EffectRef& effect,
           const StackFit& how,
           const Progress& progress) {
    add_together({effect}, how, progress);
  }
  /// One change, undone as one; each is a rung of its own, fitted in this
  /// order. What was ended by hand before, and then undone, is fitted to its
  /// end.
  /// @throws InputError for an effect that is in the list already, has no such
  ///   place, or would share a size with another
  void add_together(const std::vector<EffectRef>& effects,
                    const StackFit& how,
                    const Progress& progress);
  /// Switches an effect off or on; those after it are fitted anew.
  /// @throws InputError where there is no such effect
  void toggle(std::size_t effect,
              const StackFit& how,
              const Progress& progress);
  /// Puts in what another stack had, on a stack where nothing was done yet. A
  /// history of effects alone is told as if they had been added in their order
  /// and then switched off.
  /// @throws InputError for an effect that is there twice or has no such place
  void restore(const EffectHistory& history,
               const StackFit& how,
               const Progress& progress);
  /// Takes the last change back; false when there is none.
  bool undo(const StackFit& how, const Progress& progress);
  /// Does what was undone last again; false when there is none.
  bool redo(const StackFit& how, const Progress& progress);

  [[nodiscard]] const std::vector<AddedEffect>& effects() const {
    return history_.now;
  }
  [[nodiscard]] const EffectHistory& history() const { return history_; }
  /// Base first, then what is uncertain, then one per effect that is on.
  [[nodiscard]] const std::vector<Fit>& fits() const { return fits_; }

 private:
  using Effects = EffectHistory::Effects;

  /// @param kept fits that end early; those newly ended are put in
  void change_to(const Effects& effects,
                 std::vector<EarlyStoppedFit> kept,
                 const StackFit& how,
                 const Progress& progress);
  [[nodiscard]] std::vector<Fit> fits_for(const std::vector<EffectRef>& wanted,
                                          std::vector<EarlyStoppedFit>& kept,
                                          const StackFit& how,
                                          const Progress& progress) const;
  /// Kept fits that an undo can lead to, or that are in the model.
  [[nodiscard]] std::vector<EarlyStoppedFit> still_kept() const;

  bool uncertain_;
  EffectHistory history_;
  std::vector<Fit> fits_;
};

}  // namespace tapfit::updating
