// The room tui/workbench. What is known so far and the thread that works out
// more. In:  A workbench: the session, or a fake one in tests. Out: Snapshots
// that never change, for screens to draw. May include: its row in
// CONTRIBUTING.md.
//
// What is known so far: shared, unchanging results that the worker hands over
// and the screens draw.
#pragma once

#include "signal/checks/frf_checks.hpp"
#include "tui/widgets/trace.hpp"
#include "tui/widgets/wireframe.hpp"
#include "tui/workbench/run_look.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/session.hpp"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::tui {

/// A result of the work that screens may need.
enum class Stage {
  Model,  ///< the deck and its wireframe
  Traces,
  Hits,
  Findings,  ///< what is wrong with the test
  RunLook,   ///< of one run
  Frfs,
  FrfChecks,
  Modes,
  Cmif,
  BaseComparison,
  Comparison,
  Ladder,   ///< and the model's parameters
  Records,  ///< how the ladder's fits came about
  Diagnosis,
  Robustness,  ///< of the diagnosis
  Signature,
  EffectEvidence,     ///< of one of Snapshot::effects
  CandidateEvidence,  ///< of one of the diagnosis
  LocalisationMap,
};

/// "hits", "diagnosis": for progress and messages.
[[nodiscard]] std::string name(Stage stage);

/// One result.
struct Need {
  Stage stage = Stage::Hits;
  /// Of a signature; of a run's look the run, of evidence the index.
  int node = 0;

  auto operator<=>(const Need&) const = default;
};

/// The index of evidence for what is uncertain in the model.
inline constexpr int of_uncertain = -1;

struct Snapshot {
  template <class T>
  using Shared = std::shared_ptr<const T>;
  using Effects = std::vector<updating::EffectRef>;

  Shared<acquisition::TestBundle> bundle;
  bool has_model = false;
  Shared<structure::Deck> deck;
  Shared<Wireframe> wire;
  Shared<std::vector<Trace>> traces;
  std::vector<acquisition::LeftOut> left_out;  ///< runs that cannot be used
  Shared<acquisition::HitSet> hits;
  updating::HitActs hit_acts;  ///< judgements overruled by hand
  Shared<std::vector<Finding>> findings;
  std::map<int, Shared<RunLook>> run_looks;
  Shared<signal::FrfSet> frfs;
  Shared<signal::FrfChecks> frf_checks;
  Shared<modal::ModeSet> modes;
  /// Lines x singular values, or one column of summed FRFs where no matrix of
  /// FRFs is complete.
  Shared<Eigen::MatrixXd> cmif;
  Shared<updating::Comparison> base_comparison;
  Shared<updating::Comparison> comparison;
  Shared<updating::Comparison> previous;  ///< before the last add or undo
  Shared<std::vector<updating::Rung>> ladder;
  Shared<std::vector<updating::Estimate>> parameters;
  Shared<std::vector<updating::UpdateRecord>> records;
  Shared<updating::Diagnosis> diagnosis;
  Shared<updating::Diagnosis> last_diagnosis;  ///< of the model before
  /// What a diagnosis that runs, or was stopped, has tried; no verdict.
  Shared<updating::Diagnosis> preliminary;
  std::vector<updating::AddedEffect> effects;
  bool unsaved = false;  ///< what was done last could not be written down
  /// What was found on the way, with the effects that were in the model then.
  std::vector<std::pair<Effects, Shared<updating::Diagnosis>>> diagnoses;
  std::map<int, Shared<updating::Signature>> signatures;
  /// What effects do for the model, by their index; of those that the model
  /// has, and of the diagnosis's candidates.
  std::map<int, Shared<updating::EffectEvidence>> effect_evidence;
  std::map<int, Shared<updating::EffectEvidence>> candidate_evidence;
  /// How well each grid alone explains what is missing, the best first.
  Shared<std::vector<updating::GridShare>> localisation_map;

  [[nodiscard]] bool has(const Need& need) const;
  /// Drops what depends on the hits.
  void forget_from_hits();
  /// Drops what depends on the modes.
  void forget_from_modes();
  /// Drops what depends on which modes are paired.
  void forget_pairs();
  /// Drops what depends on the current model.
  void forget_model_results();
  /// The effects that are in the model.
  [[nodiscard]] Effects effects_on() const;
  /// What was found missing from the base model with the effects wanted, if it
  /// was looked for.
  [[nodiscard]] Shared<updating::Diagnosis> diagnosis_of(
      const Effects& wanted) const;
  /// Takes over the effects that the model now has.
  void change_effects(std::vector<updating::AddedEffect> now);
};

}  // namespace tapfit::tui
