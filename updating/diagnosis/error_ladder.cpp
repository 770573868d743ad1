#include "updating/diagnosis/error_ladder.hpp"

#include "updating/fit/estimates.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace tapfit::updating {

std::vector<Rung> ladder_of(Fit fit,
                            const std::vector<SelectedEffect>& all,
                            std::size_t already,
                            const Fitter& fitter,
                            const Progress& progress) {
  const effects::TestContext& context = fitter.problem().context;
  std::vector<std::size_t> left;
  for (std::size_t k = already; k < fit.effects.size(); ++k) left.push_back(k);
  std::vector<EffectInstance> so_far(
      fit.effects.begin(),
      fit.effects.begin() + static_cast<std::ptrdiff_t>(already));
  std::vector<Rung> ladder;
  while (!left.empty()) {
    std::size_t next = left.front();
    std::optional<Fit> best;
    for (const std::size_t k : left) {
      if (left.size() == 1) break;
      std::vector<EffectInstance> tried = so_far;
      tried.push_back(fit.effects[k]);
      Fit with = fitter.fit(tried, fitter.model_for(tried), progress);
      if (best && with.result.error >= best->result.error) continue;
      best = std::move(with);
      next = k;
    }
    const double least =
        best ? fitter.settled(std::move(*best), progress).result.error
             : fit.result.error;
    Rung rung;
    rung.added = all[next - already].name;
    rung.probability = all[next - already].probability;
    rung.alike = all[next - already].alike;
    rung.where = fit.effects[next].where;
    rung.error = least;
    rung.place_sd = all[next - already].place_sd;
    rung.sizes = fit.effects[next].p;
    fit.result.state.effects[next].place_sd = rung.place_sd;
    rung.parameters = effect_estimates(fit, next, context);
    if (const auto& extent = all[next - already].extent) {
      widen(*extent, rung.parameters.front());
    }
    ladder.push_back(std::move(rung));
    so_far.push_back(fit.effects[next]);
    left.erase(std::find(left.begin(), left.end(), next));
  }
  return ladder;
}

void lead_with_ladder(std::vector<Candidate>& candidates,
                      const std::vector<Rung>& ladder,
                      double error,
                      double held_out_error) {
  const std::vector<Rung> last_first(ladder.rbegin(), ladder.rend());
  for (const Rung& rung : last_first) {
    const std::string kind = leading_kind(rung);
    Candidate lead;
    const auto it = std::find_if(
        candidates.begin(), candidates.end(), [&](const Candidate& c) {
          return c.effect == kind && c.where == rung.where;
        });
    if (it != candidates.end()) {
      lead = *it;
      candidates.erase(it);
    }
    lead.effect = kind;
    lead.probability = rung.probability;
    lead.where = rung.where;
    lead.indistinguishable_from = rung.alike;
    lead.parameters = rung.parameters;
    lead.place_sd = rung.place_sd;
    lead.sizes = rung.sizes;
    lead.error = error;
    lead.held_out_error = held_out_error;
    candidates.insert(candidates.begin(), lead);
  }
}

}  // namespace tapfit::updating
