// What was done to a test by hand, as a file that people can read: hits that
// were overruled, modes that were edited, effects that were added, what of it
// was undone, and the error ladder they gave.
#pragma once

#include "updating/comparison/comparison.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/early_stopped_fit.hpp"
#include "updating/fit/rung.hpp"
#include "updating/measurement/mode_choices.hpp"
#include "updating/measurement/overruled_hit.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/effect_change.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::updating {

/// A rung and the model's modes with it.
struct SavedRung {
  Rung rung;
  std::vector<ModePair> modes;
};

struct SavedSession {
  std::string title;                        ///< of the bundle
  std::vector<OverruledHit> overruled;      ///< as HitActs::done
  std::vector<OverruledHit> restored = {};  ///< as HitActs::undone
  ModeChoices modes;
  std::vector<AddedEffect> effects;
  std::vector<EffectChange> undone = {};   ///< for a redo, the next one last
  std::vector<EarlyStoppedFit> kept = {};  ///< fits that were ended by hand
  std::vector<SavedRung> ladder;           ///< what came out when it was saved

  /// Whether nothing was done that could be lost.
  [[nodiscard]] bool empty() const {
    return overruled.empty() && restored.empty() && modes.empty() &&
           effects.empty() && undone.empty();
  }
};

/// The file's text: JSON.
[[nodiscard]] std::string as_text(const SavedSession& session);

/// Replaces the file as a whole or not at all.
/// @throws InputError where it cannot be written
void write_saved_session(const std::filesystem::path& file,
                         const SavedSession& session);

/// @throws InputError for a file that is missing or no such session; says
///   where in it
[[nodiscard]] SavedSession read_saved_session(
    const std::filesystem::path& file);

}  // namespace tapfit::updating
