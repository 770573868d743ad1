#include "updating/diagnosis/error_ladder.hpp"

#include "updating/fit/estimates.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tapfit::updating {

namespace {

// By what is not known of the place. Intervals are those of logarithms.
void widen(const std::vector<double>& place_sd,
           std::vector<Estimate>& parameters) {
  constexpr double in_95 = 1.96;  // standard deviations
  const std::size_t count = std::min(place_sd.size(), parameters.size());
  for (std::size_t k = 0; k < count; ++k) {
    Estimate& e = parameters[k];
    if (!(e.value > 0.0) || !(e.lo95 > 0.0)) continue;
    const double own = in_95 * place_sd[k];
    e.lo95 = e.value / std::exp(std::hypot(std::log(e.value / e.lo95), own));
    e.hi95 = e.value * std::exp(std::hypot(std::log(e.hi95 / e.value), own));
    e.sd = std::hypot(e.sd, e.value * place_sd[k]);
  }
}

}  // namespace

std::vector<Rung> ladder_of(const Fit& fit,
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
    double least = 1e300;
    std::size_t next = left.front();
    for (const std::size_t k : left) {
      if (left.size() == 1) {
        least = fit.result.error;
        break;
      }
      std::vector<EffectInstance> tried = so_far;
      tried.push_back(fit.effects[k]);
      const Fit with = fitter.fit(tried, fitter.model_for(tried), progress);
      if (with.result.error < least) {
        least = with.result.error;
        next = k;
      }
    }
    Rung rung;
    rung.added = all[next - already].name;
    rung.probability = all[next - already].probability;
    rung.alike = all[next - already].alike;
    rung.where = fit.effects[next].where;
    rung.error = least;
    rung.parameters = effect_estimates(fit, next, context);
    if (const auto& extent = all[next - already].extent) {
      widen(*extent, rung.parameters.front());
    }
    widen(all[next - already].place_sd, rung.parameters);
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
    lead.error = error;
    lead.held_out_error = held_out_error;
    candidates.insert(candidates.begin(), lead);
  }
}

}  // namespace tapfit::updating
