#include "updating/comparison/effect_evidence.hpp"

#include <algorithm>

namespace tapfit::updating {

EffectEvidence effect_evidence(const Comparison& without,
                               const Comparison& with) {
  EffectEvidence found;
  found.error_without = without.error;
  found.error_with = with.error;
  const std::size_t count = std::min({without.frf_error.size(),
                                      with.frf_error.size(),
                                      without.model_frfs.size(),
                                      with.model_frfs.size()});
  // Errors add up by their squares.
  const auto drop = [&](std::size_t frf) {
    const double before = without.frf_error[frf];
    const double after = with.frf_error[frf];
    return (before - after) * (before + after);
  };
  for (std::size_t frf = 0; frf < count; ++frf) {
    if (!found.frf || drop(frf) > drop(*found.frf)) found.frf = frf;
  }
  if (!found.frf) return found;
  found.frf_error_without = without.frf_error[*found.frf];
  found.frf_error_with = with.frf_error[*found.frf];
  found.without = without.model_frfs[*found.frf];
  found.with = with.model_frfs[*found.frf];
  return found;
}

}  // namespace tapfit::updating
