#include "tui/snapshot.hpp"

namespace tapfit::tui {

std::string name(Stage stage) {
  switch (stage) {
    case Stage::Model:
      return "model";
    case Stage::Traces:
      return "recordings";
    case Stage::Hits:
      return "hits";
    case Stage::Frfs:
      return "FRFs";
    case Stage::Modes:
      return "modes";
    case Stage::BaseComparison:
      return "comparison with the base model";
    case Stage::Comparison:
      return "comparison";
    case Stage::Ladder:
      return "parameters";
    case Stage::Diagnosis:
      return "diagnosis";
    case Stage::Signature:
      return "signature";
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
    case Stage::Frfs:
      return frfs != nullptr;
    case Stage::Modes:
      return modes != nullptr;
    case Stage::BaseComparison:
      return base_comparison != nullptr;
    case Stage::Comparison:
      return comparison != nullptr;
    case Stage::Ladder:
      return ladder != nullptr;
    case Stage::Diagnosis:
      return diagnosis != nullptr;
    case Stage::Signature:
      return signatures.contains(need.node);
  }
  return true;
}

void Snapshot::forget_model_results() {
  if (comparison) previous = comparison;
  comparison.reset();
  ladder.reset();
  parameters.reset();
  diagnosis.reset();
  signatures.clear();
}

void Snapshot::change_effects(std::size_t count, bool seen_before) {
  if (diagnosis) diagnoses[effects] = diagnosis;
  forget_model_results();
  effects = count;
  if (!seen_before)
    diagnoses.erase(diagnoses.lower_bound(count), diagnoses.end());
  const auto known = diagnoses.find(count);
  if (known != diagnoses.end()) diagnosis = known->second;
}

void Snapshot::forget_from_hits() {
  forget_model_results();
  diagnoses.clear();
  effects = 0;  // the session starts from the base model again
  hits.reset();
  frfs.reset();
  modes.reset();
  base_comparison.reset();
  previous.reset();  // on other lines, perhaps
}

}  // namespace tapfit::tui
