#include "tui/workbench/snapshot.hpp"

#include "updating/localisation/signature.hpp"
#include "updating/session/added_effect.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::tui {

std::string name(Stage stage) {
  switch (stage) {
    case Stage::Model:
      return "model";
    case Stage::Traces:
      return "recordings";
    case Stage::Hits:
      return "hits";
    case Stage::Findings:
      return "checks of the test";
    case Stage::RunLook:
      return "windows and averages of the run";
    case Stage::Frfs:
      return "FRFs";
    case Stage::FrfChecks:
      return "checks of the FRFs";
    case Stage::Modes:
      return "modes";
    case Stage::Cmif:
      return "mode indicator";
    case Stage::BaseComparison:
      return "comparison with the base model";
    case Stage::Comparison:
      return "comparison";
    case Stage::Ladder:
      return "parameters";
    case Stage::Records:
      return "record of the fits";
    case Stage::Diagnosis:
      return "diagnosis";
    case Stage::Robustness:
      return "how firm the verdict is";
    case Stage::Signature:
      return "signature";
    case Stage::EffectEvidence:
    case Stage::CandidateEvidence:
      return "FRFs with and without the effect";
    case Stage::LocalisationMap:
      return "signature of every grid";
  }
  return "?";
}

bool Snapshot::has(const Need& need) const {
  switch (need.stage) {
    case Stage::Model:
      return wire != nullptr;
    case Stage::Traces:
      return traces != nullptr;
    case Stage::Hits:
      return hits != nullptr;
    case Stage::Findings:
      return findings != nullptr;
    case Stage::RunLook:
      return run_looks.contains(need.node);
    case Stage::Frfs:
      return frfs != nullptr;
    case Stage::FrfChecks:
      return frf_checks != nullptr;
    case Stage::Modes:
      return modes != nullptr;
    case Stage::Cmif:
      return cmif != nullptr;
    case Stage::BaseComparison:
      return base_comparison != nullptr;
    case Stage::Comparison:
      return comparison != nullptr;
    case Stage::Ladder:
      return ladder != nullptr;
    case Stage::Records:
      return records != nullptr;
    case Stage::Diagnosis:
      return diagnosis != nullptr;
    case Stage::Robustness:
      return diagnosis != nullptr && !diagnosis->robustness.empty();
    case Stage::Signature:
      return signatures.contains(need.node);
    case Stage::EffectEvidence:
      return effect_evidence.contains(need.node);
    case Stage::CandidateEvidence:
      return candidate_evidence.contains(need.node);
    case Stage::LocalisationMap:
      return localisation_map != nullptr;
  }
  return true;
}

void Snapshot::forget_model_results() {
  if (comparison) previous = comparison;
  comparison.reset();
  ladder.reset();
  parameters.reset();
  records.reset();
  diagnosis.reset();
  preliminary.reset();
  signatures.clear();
  effect_evidence.clear();
  candidate_evidence.clear();
  localisation_map.reset();
}

Snapshot::Effects Snapshot::effects_on() const {
  Effects on;
  for (const updating::AddedEffect& added : effects) {
    if (added.on) on.push_back(added.ref);
  }
  return on;
}

Snapshot::Shared<updating::Diagnosis> Snapshot::diagnosis_of(
    const Effects& wanted) const {
  if (diagnosis && wanted == effects_on()) return diagnosis;
  const auto known = std::find_if(
      diagnoses.begin(), diagnoses.end(), [&wanted](const auto& entry) {
        return entry.first == wanted;
      });
  return known == diagnoses.end() ? nullptr : known->second;
}

void Snapshot::change_effects(std::vector<updating::AddedEffect> now) {
  const Effects before = effects_on();
  const auto found = diagnosis;
  diagnosis.reset();
  if (found) last_diagnosis = found;
  if (found && !diagnosis_of(before)) diagnoses.emplace_back(before, found);
  forget_model_results();
  effects = std::move(now);
  diagnosis = diagnosis_of(effects_on());
}

void Snapshot::forget_from_modes() {
  forget_model_results();
  diagnoses.clear();
  last_diagnosis.reset();
  modes.reset();
  findings.reset();
  base_comparison.reset();
  previous.reset();  // on other lines, perhaps
}

void Snapshot::forget_from_hits() {
  forget_from_modes();
  hits.reset();
  run_looks.clear();
  frfs.reset();
  frf_checks.reset();
  cmif.reset();
}

void Snapshot::forget_pairs() {
  comparison.reset();
  base_comparison.reset();
  previous.reset();
}

}  // namespace tapfit::tui
