// What a report is written from: the results of one test's work, gathered.
#pragma once

#include "acquisition/bundle/test_notes.hpp"
#include "acquisition/hits/hits.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/measurement/overruled_hit.hpp"
#include "updating/session/session.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::tui {

/// Model against measurement.
struct ModelResults {
  structure::Deck deck;
  updating::Comparison before;
  updating::Comparison after;
  std::vector<updating::Rung> ladder;  ///< base first
  /// Of each rung above the base.
  std::vector<updating::EffectEvidence> evidence;
  /// Of the last model: uncertain properties, the model's corrections, then the
  /// parameters of each effect under "EFFECT NAME".
  std::vector<updating::Estimate> parameters;
  std::optional<updating::Diagnosis> diagnosis;  ///< of the base model
  std::optional<updating::Diagnosis> rest;       ///< of the last model
  std::optional<updating::Signature> signature;  ///< of the base model
};

struct ReportData {
  std::filesystem::path path;  ///< of the bundle
  std::string date;            ///< of the report
  acquisition::TestBundle bundle;
  acquisition::TestNotes notes;
  std::optional<acquisition::HitSet> hits;
  std::vector<updating::OverruledHit> overruled;
  signal::FrfSet frfs;
  modal::ModeSet modes;
  std::optional<ModelResults> model;
  std::vector<std::string> warnings;
  /// Libraries with their versions, the program's own first; may be empty.
  std::vector<std::pair<std::string, std::string>> versions = {};
};

/// The work as it stands. Where no effect was ever added, what the diagnosis of
/// the base model supports is added first.
///
/// @param session of that bundle; its model changes where nothing was added
/// @throws InputError, Stopped
[[nodiscard]] ReportData report_data(updating::Session& session,
                                     const std::filesystem::path& bundle,
                                     const Progress& progress);

/// "2026-11-25"; of SOURCE_DATE_EPOCH where the environment sets it.
[[nodiscard]] std::string today();

}  // namespace tapfit::tui
