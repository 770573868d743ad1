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

double error_with(const std::vector<updating::Rung>& ladder,
                  std::size_t effects,
                  const updating::Diagnosis& diagnosis) {
  const auto own = std::count_if(
      ladder.begin(), ladder.end(), [](const updating::Rung& rung) {
        return rung.added != updating::base_rung &&
               rung.added != updating::uncertain_rung;
      });
  const std::size_t others = ladder.size() - static_cast<std::size_t>(own);
  if (effects == 0) {
    return ladder.empty() ? diagnosis.error_base : ladder.front().error;
  }
  return others + effects <= ladder.size() ? ladder[others + effects - 1].error
                                           : diagnosis.error_base;
}

double error_found(const std::vector<updating::Rung>& ladder,
                   std::size_t effects,
                   const updating::Diagnosis& d) {
  std::vector<updating::EffectRef> added;
  for (const updating::Rung& rung : ladder) {
    added.push_back({rung.added, rung.where});
  }
  const std::vector<updating::EffectRef> found = verdict_of(d);
  const auto at = std::ranges::search(added, found);
  return found.empty() || at.empty()
             ? d.error_best
             : error_with(ladder, effects + found.size(), d);
}

}  // namespace tapfit::tui
