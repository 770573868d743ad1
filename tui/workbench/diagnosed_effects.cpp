#include "tui/workbench/diagnosed_effects.hpp"

#include <algorithm>

namespace tapfit::tui {

using updating::EffectRef;

EffectRef ref_of(const updating::Candidate& c) {
  return {c.effect, c.where, c.place_sd, c.sizes};
}

std::vector<EffectRef> verdict_of(const updating::Diagnosis& diagnosis) {
  std::vector<EffectRef> refs;
  for (const updating::Rung& rung : diagnosis.ladder) {
    const std::string kind = updating::leading_kind(rung);
    if (kind == updating::nonlinearity) continue;
    refs.push_back({kind, rung.where, rung.place_sd, rung.sizes});
  }
  return refs;
}

std::vector<EffectRef> found_with(const updating::Diagnosis& diagnosis,
                                  const updating::Candidate& candidate) {
  const EffectRef own = ref_of(candidate);
  std::vector<EffectRef> verdict = verdict_of(diagnosis);
  const bool part = std::ranges::find(verdict, own) != verdict.end();
  return part ? verdict : std::vector{own};
}

}  // namespace tapfit::tui
