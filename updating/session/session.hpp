// The room updating/session. One test from recording to updated model, with
// undo and a file.
// In:  A bundle's folder and what the user does.
// Out: Every stage's result. The screens and the command line stand on this
//      alone.
// May include: its row in CONTRIBUTING.md.
//
// One test, worked through from recording to updated model. Each stage's result
// is computed when first asked for and dropped when a stage to its left
// changes. The terminal screens and the command line are both thin over this.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "acquisition/hits/hits.hpp"
#include "acquisition/hits/readable_recordings.hpp"
#include "modal/identify/identify_modes.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/comparison/comparison.hpp"
#include "updating/comparison/effect_evidence.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/fit/estimate.hpp"
#include "updating/fit/rung.hpp"
#include "updating/fit/update_choice.hpp"
#include "updating/fit/update_record.hpp"
#include "updating/localisation/localisation_map.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/measurement/mode_choices.hpp"
#include "updating/prediction/prediction.hpp"
#include "updating/prediction/stated_change.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/structure/deck/deck.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace tapfit::updating {

struct FittedTest;
struct SessionStages;

class Session {
 public:
  /// Reads the bundle's test.json (not yet its recordings).
  /// @throws InputError
  explicit Session(
      const std::filesystem::path& bundle,
      acquisition::Unreadable unreadable = acquisition::Unreadable::Refused);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  /// The same test with all that was measured and found missing in a session of
  /// its own: what is done there leaves this one as it is.
  [[nodiscard]] Session beside() const;

  // Each stage: computed on first use, kept. May take long, hence progress.
  // @throws InputError for what the input does not allow; Stopped.
  const acquisition::TestBundle& bundle() const;
  bool has_model() const;
  const structure::Deck& deck(const Progress& progress = {});
  const std::vector<acquisition::Recording>& recordings(
      const Progress& progress = {});
  /// Runs that cannot be used, as far as recordings() and hits() have shown.
  const std::vector<acquisition::LeftOut>& left_out() const;
  const acquisition::HitSet& hits(const Progress& progress = {});
  const signal::FrfSet& frfs(const Progress& progress = {});
  /// The FRFs of recordings with another estimator or window.
  /// @throws InputError as of signal::estimate_frfs
  signal::FrfSet frfs_as(const signal::FrfOptions& options,
                         const Progress& progress = {});
  const modal::ModeSet& modes(const Progress& progress = {});
  /// The current model (base, or with what was added) against measurement. Its
  /// floor allows the deck's form no more than what known diagnoses leave it.
  const Comparison& comparison(const Progress& progress = {});
  /// The base model's comparison, whatever has been added since.
  const Comparison& base_comparison(const Progress& progress = {});
  /// Ranks what is missing from the current model; what an earlier run of the
  /// program found is taken as it was.
  const Diagnosis& diagnosis(const Progress& progress = {});
  /// The same with what becomes of it when what was assumed is changed.
  const Diagnosis& robust_diagnosis(const Progress& progress = {});
  /// What an earlier run of the program, or this one, found missing with the
  /// first of the current effects in the model and kept; nothing is worked out.
  /// @param effects how many of those that are on, from 0
  std::optional<Diagnosis> known_diagnosis(std::size_t effects,
                                           const Progress& progress = {});
  /// Missing dynamic stiffness at a grid, for the current model.
  Signature signature(int node, const Progress& progress = {});
  /// What an effect does for the current model; see find_evidence.hpp.
  /// @param added tried along with those of the model, the effect among them
  ///   where it was not added
  /// @throws InputError for an effect that has no such place
  EffectEvidence evidence(const EffectRef& effect,
                          const std::vector<EffectRef>& added = {},
                          const Progress& progress = {});
  /// What known changes will do to the structure, by the current model; what is
  /// uncertain is fitted first where nothing was.
  /// @throws InputError as of updating::predict_change
  Prediction predict(const std::vector<StatedChange>& changes,
                     const Progress& progress = {});
  /// How well each grid explains what is missing, the best first.
  std::vector<GridShare> localisation_map(const Progress& progress = {});

  /// Accept or reject a hit by hand; FRFs and all after are made anew, with
  /// the same effects.
  void overrule_hit(std::size_t run, std::size_t hit);

  /// What is to hold about the modes from now on: the modes are identified
  /// anew, or only paired anew, and so is what follows from them. Where it
  /// fails, all stays as it was.
  /// @throws InputError for a pole that is not there to be dropped or added
  void choose_modes(const ModeChoices& choices, const Progress& progress = {});
  const ModeChoices& mode_choices() const;
  /// Takes the last choose_modes() back; false when there is none.
  bool undo_modes(const Progress& progress = {});
  /// Does again what undo_modes() took back last; false when there is none.
  bool redo_modes(const Progress& progress = {});

  /// How fits from now on identify their parameters.
  /// @throws InputError for lines of which the bundle's band holds none
  void set_update(const UpdateChoice& choice);
  /// Adds an effect to the current model and identifies all parameters anew.
  void add(const EffectRef& effect, const Progress& progress = {}) {
    add_together({effect}, progress);
  }
  /// Adds effects in this order as one step: the same rungs as one by one, and
  /// one undo. Where one of them fails, none is added.
  void add_together(const std::vector<EffectRef>& effects,
                    const Progress& progress = {});
  /// Switches an added effect off or on, counted from 0.
  void toggle(std::size_t effect, const Progress& progress = {});
  /// Identifies what is uncertain in the model with no effect added; to be
  /// called before any is. A rung of its own, "uncertain properties".
  void fit_uncertain(const Progress& progress = {});
  /// Takes the last add() or toggle() back; false when there is none.
  bool undo(const Progress& progress = {});
  /// Does again what was undone last; false when there is none.
  bool redo(const Progress& progress = {});
  /// All that were added, also those switched off.
  std::vector<AddedEffect> effects() const;
  const std::vector<OverruledHit>& overruled() const;

  /// What was done by hand so far, for write_saved_session(); with the ladder
  /// where it is known.
  SavedSession saved(const Progress& progress = {});
  /// Does all of it again as soon as the stages are there, on a session where
  /// nothing was done yet. They throw InputError for a hit or a place that is
  /// no more.
  void take_up(const SavedSession& saved);

  /// Base rung first, then one per effect that is on.
  const std::vector<Rung>& ladder(const Progress& progress = {});
  /// Parameters of the current model, uncertain base ones included.
  std::vector<Estimate> model_parameters(const Progress& progress = {});

  /// What the deck of the current model is wrong by in form.
  std::vector<ModelForm> model_form(const Progress& progress = {});

  /// What fits of several tests together need of this one.
  FittedTest fitted(const Progress& progress = {});

  /// How each of the ladder's fits came about: no base rung.
  std::vector<UpdateRecord> update_records(const Progress& progress = {});
  /// Runs that fits leave out, since they are of another structure.
  std::vector<SetUpMistake> run_outliers(const Progress& progress = {});
  /// What of the model stands in the way of comparing it: mechanisms, a floor
  /// that is too high; runs that are left out; of a test of modes also what
  /// these do not tell.
  std::vector<std::string> model_warnings(const Progress& progress = {});
  /// Of FRFs through the reduced base, see BaseBuilder::error().
  double base_error(const Progress& progress = {});

 private:
  explicit Session(std::unique_ptr<SessionStages> stages);

  std::unique_ptr<SessionStages> stages_;
};

}  // namespace tapfit::updating
