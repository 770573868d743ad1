#include "updating/diagnosis/candidate.hpp"

#include "updating/fit/estimates.hpp"

#include <algorithm>

namespace tapfit::updating {

Candidate candidate_of(const Fit& fit, const effects::TestContext& context) {
  const EffectInstance& own = fit.effects.back();
  Candidate c;
  c.effect = own.effect->name();
  c.where = own.where;
  c.sizes = own.p;
  c.place_sd = fit.result.state.effects.back().place_sd;
  c.parameters = effect_estimates(fit, fit.effects.size() - 1, context);
  c.error = fit.result.error;
  return c;
}

Diagnosis with_tried(const Diagnosis* before, const Candidate& candidate) {
  Diagnosis d = before != nullptr ? *before : Diagnosis{};
  std::erase_if(d.candidates, [&candidate](const Candidate& known) {
    return known.effect == candidate.effect && known.where == candidate.where;
  });
  const auto next = std::ranges::upper_bound(
      d.candidates, candidate.error, {}, &Candidate::error);
  d.candidates.insert(next, candidate);
  d.error_best = d.candidates.front().error;
  return d;
}

}  // namespace tapfit::updating
