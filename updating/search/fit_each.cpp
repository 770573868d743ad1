#include "updating/search/fit_each.hpp"

#include "updating/search/work_on_each.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {
namespace {

std::vector<EffectInstance> with(const Fit& current,
                                 const EffectInstance& more) {
  std::vector<EffectInstance> effects = current.effects;
  effects.push_back(more);
  return effects;
}

void drop_implausible(std::vector<Hypothesis>& found) {
  std::erase_if(found, [](const Hypothesis& h) {
    return !h.own().effect->is_plausible(h.own().where, h.own().p);
  });
}

// Lines x FRFs x parameters are most of what a fit takes, and there are
// hundreds of them.
Fit without_jacobian(Fit fit) {
  fit.result.jacobian.resize(0, 0);
  return fit;
}

}  // namespace

bool less_error(const Hypothesis& a, const Hypothesis& b) {
  return a.fit.result.error < b.fit.result.error;
}

bool is_likelier(const Hypothesis& a, const Hypothesis& b) {
  return a.fit.log_likelihood > b.fit.log_likelihood;
}

std::shared_ptr<const FrfModel> shared_base(
    const Fit& current,
    const std::vector<EffectInstance>& tries,
    const Fitter& fitter) {
  std::vector<EffectInstance> all = current.effects;
  all.insert(all.end(), tries.begin(), tries.end());
  return fitter.model_for(all);
}

std::optional<Hypothesis> approach_one(
    const Fit& current,
    const EffectInstance& more,
    const Fitter& fitter,
    const std::shared_ptr<const FrfModel>& shared,
    const Reach& reach,
    const Progress& progress) {
  const std::vector<EffectInstance> effects = with(current, more);
  std::optional<Fit> fit =
      fitter.approach(effects,
                      shared ? shared : fitter.model_for(effects),
                      progress,
                      reach.hopeless_wide_error());
  if (!fit) return std::nullopt;
  return reach.judged(without_jacobian(std::move(*fit)));
}

std::vector<Hypothesis> those_left(
    std::vector<std::optional<Hypothesis>> approached) {
  std::vector<Hypothesis> result;
  for (std::optional<Hypothesis>& h : approached) {
    if (h) result.push_back(std::move(*h));
  }
  return result;
}

Hypothesis arrive(Hypothesis approached,
                  const Fitter& fitter,
                  const Reach& reach,
                  const Progress& progress) {
  return reach.judged(
      without_jacobian(fitter.arrive(std::move(approached.fit), progress)));
}

void drop_hopeless(std::vector<Hypothesis>& found, const Reach& reach) {
  if (found.empty()) return;
  std::iter_swap(found.begin(),
                 std::min_element(found.begin(), found.end(), is_likelier));
  const double least = std::min_element(found.begin(), found.end(), less_error)
                           ->fit.result.error;
  const auto hopeless = [&](const Hypothesis& h) {
    return h.fit.result.error > least && reach.is_hopeless(h);
  };
  found.erase(std::remove_if(found.begin() + 1, found.end(), hopeless),
              found.end());
}

std::vector<Hypothesis> fit_each(const Fit& current,
                                 const std::vector<EffectInstance>& extras,
                                 const Fitter& fitter,
                                 Reach& reach,
                                 const Progress& progress) {
  const Progress silent{{}, progress.stop};
  std::vector<std::optional<Hypothesis>> approached(extras.size());
  work_on_each(
      extras.size(), silent, [&](std::size_t k, const Progress& quiet) {
        approached[k] =
            approach_one(current, extras[k], fitter, nullptr, reach, quiet);
      });
  std::vector<Hypothesis> result = those_left(std::move(approached));
  for (const Hypothesis& h : result) reach.take(h);
  drop_hopeless(result, reach);
  work_on_each(
      result.size(), silent, [&](std::size_t k, const Progress& quiet) {
        result[k] = arrive(std::move(result[k]), fitter, reach, quiet);
      });
  drop_implausible(result);
  for (const Hypothesis& h : result) reach.take(h);
  return result;
}

std::vector<Hypothesis> fit_each_beside(
    const Fit& beside,
    const Fit& current,
    const std::vector<EffectInstance>& extras,
    const Fitter& fitter,
    const std::shared_ptr<const FrfModel>& shared,
    const Reach& reach,
    const Progress& progress) {
  std::vector<Hypothesis> result(extras.size());
  const Progress silent{{}, progress.stop};
  work_on_each(
      result.size(), silent, [&](std::size_t k, const Progress& quiet) {
        const std::vector<EffectInstance> effects = with(current, extras[k]);
        result[k] = reach.judged(without_jacobian(
            fitter.fit_beside(beside,
                              effects,
                              shared ? shared : fitter.model_for(effects),
                              quiet)));
      });
  drop_implausible(result);
  return result;
}

}  // namespace tapfit::updating
