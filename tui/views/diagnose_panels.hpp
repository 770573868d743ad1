// Below the list of the Diagnose screen: what the chosen one does for the FRFs
// or what is missing at its place, and where that is.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/widgets/table.hpp"
#include "tui/widgets/wireframe.hpp"
#include "updating/comparison/effect_evidence.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/localisation/localisation_map.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/structure/deck/deck.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace tapfit::tui {

/// What is shown: the diagnosis of the model, what it has tried so far, or that
/// of the model before.
enum class Standing { Final, Preliminary, Outdated };

struct DiagnoseInput {
  const acquisition::TestBundle& bundle;
  const updating::Diagnosis& diagnosis;
  const std::map<int, std::shared_ptr<const updating::Signature>>& signatures;
  const Wireframe* wire = nullptr;
  /// How well each grid alone explains what is missing, once it is known.
  const std::vector<updating::GridShare>* map = nullptr;
  Standing standing = Standing::Final;
  const structure::Deck* deck = nullptr;  ///< for where elements are
  const signal::FrfSet* frfs = nullptr;
  /// Of the chosen one, once it is known.
  const updating::EffectEvidence* evidence = nullptr;
  /// What the user went to, where it is not among these candidates.
  const updating::EffectRef* missing = nullptr;
};

/// Of that: why, and what to do.
[[nodiscard]] std::string missing_words(const updating::EffectRef& missing,
                                        Standing standing);

struct DiagnoseState {
  ListState list;  ///< candidates
  /// To be added together; also such as are not in the list (any more).
  std::vector<updating::EffectRef> tagged;
  PlotRange range;  ///< [Hz], of the signature
  Pose pose;
  bool map = false;       ///< all grids instead of the candidate's place
  bool all_laws = false;  ///< mass, spring and dashpot, not the best alone
  bool evidence = false;  ///< FRFs also where there is a signature
  /// All in words, from that line on, in place of table and plots.
  std::optional<int> details = {};
  /// How firm the verdict is, likewise.
  std::optional<int> firmness = {};
};

/// Grids that the place means: its own, those of its channels' sensors, or its
/// elements' corners where there is a deck.
[[nodiscard]] std::vector<int> grids_of(const acquisition::TestBundle& bundle,
                                        const updating::Location& where,
                                        const structure::Deck* deck = nullptr);

/// The grid that the candidate's missing stiffness is drawn of; none where it
/// acts on several, and for a mistake of the set-up, which acts on none.
[[nodiscard]] std::optional<int> signature_grid(
    const acquisition::TestBundle& bundle,
    const updating::Candidate& candidate);

/// Whether the chosen one's missing dynamic stiffness says something, as far as
/// that is known: its place explains most of the misfit.
[[nodiscard]] bool has_signature(
    const acquisition::TestBundle& bundle,
    const std::map<int, std::shared_ptr<const updating::Signature>>& signatures,
    const updating::Candidate& candidate);

/// What an effect does for the FRFs.
struct EvidenceInput {
  const signal::FrfSet& frfs;
  const updating::EffectEvidence* evidence = nullptr;  ///< null: not known yet
  std::string note = {};  ///< what else there is to say
};

/// An FRF with and without the effect, and the errors.
void draw_evidence(Screen& screen,
                   const Rect& rect,
                   const EvidenceInput& input,
                   const PlotRange& range);

/// The missing dynamic stiffness over frequency.
/// @pre has_signature()
void draw_signature(Screen& screen,
                    const Rect& rect,
                    const DiagnoseInput& input,
                    const DiagnoseState& state,
                    const updating::Candidate& chosen);

/// The structure with these grids marked.
/// @param wire null while it is not known
void draw_place(Screen& screen,
                const Rect& rect,
                const Wireframe* wire,
                const Pose& pose,
                const std::vector<int>& grids);

/// Grids by how well each alone explains what is missing: those that come near
/// the best one.
void draw_map(Screen& screen,
              const Rect& rect,
              const DiagnoseInput& input,
              const DiagnoseState& state);

}  // namespace tapfit::tui
