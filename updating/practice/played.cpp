#include "updating/practice/played.hpp"

namespace tapfit::updating {

Diagnosis as_diagnosis(const std::vector<Rung>& ladder, double floor) {
  Diagnosis result;
  result.floor = floor;
  for (const Rung& rung : ladder) {
    result.error_best = rung.error;
    if (rung.added == base_rung) result.error_base = rung.error;
    if (rung.added == base_rung || rung.added == uncertain_rung) continue;
    result.verdict += (result.verdict.empty() ? "" : "+") + rung.added;
    result.ladder.push_back(rung);
  }
  if (result.verdict.empty()) result.verdict = "none";
  return result;
}

}  // namespace tapfit::updating
