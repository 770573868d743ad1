#include "updating/search/fit_planned.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/search/fit_each.hpp"
#include "updating/search/work_on_each.hpp"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>

namespace tapfit::updating {
namespace {

void share_bases(std::vector<Planned>& plans,
                 const Fit& current,
                 const Fitter& fitter) {
  for_each_parallel(plans.size(), [&](std::size_t k) {
    if (plans[k].tries.empty() || plans[k].effect->changes_stiffness()) return;
    plans[k].shared = shared_base(current, plans[k].tries, fitter);
  });
}

}  // namespace

std::vector<std::vector<Hypothesis>> fit_planned(
    std::vector<Planned> plans,
    const Fit& current,
    const Fitter& fitter,
    const HypothesisOptions& options,
    Reach& reach,
    const Progress& progress) {
  share_bases(plans, current, fitter);
  std::vector<std::vector<std::optional<Hypothesis>>> approached(plans.size());
  std::vector<std::pair<std::size_t, std::size_t>> all;  // plan, try
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const std::size_t tries = plans[k].tries.size();
    approached[k].resize(tries);
    for (std::size_t t = 0; t < tries; ++t) all.emplace_back(k, t);
  }
  std::mutex one_at_a_time;
  const auto tell = [&](const Fit& fit) {
    if (!options.tried) return;
    const std::lock_guard lock(one_at_a_time);
    options.tried(fit);
  };
  const auto begin = [&](std::size_t n, const Progress& quiet) {
    const auto [k, t] = all[n];
    approached[k][t] = approach_one(
        current, plans[k].tries[t], fitter, plans[k].shared, reach, quiet);
    if (approached[k][t]) tell(approached[k][t]->fit);
  };
  work_on_each(all.size(), part_of(progress, 0.0, 0.6), begin);
  std::vector<std::vector<Hypothesis>> found;
  for (auto& kind : approached) found.push_back(those_left(std::move(kind)));
  for (const std::vector<Hypothesis>& kind : found) {
    for (const Hypothesis& h : kind) reach.take(h);
  }
  std::vector<Hypothesis*> left;
  for (std::vector<Hypothesis>& kind : found) {
    if (options.best_of_each) {
      drop_hopeless(kind, reach);
    } else {
      std::erase_if(
          kind, [&reach](const Hypothesis& h) { return reach.is_hopeless(h); });
    }
    for (Hypothesis& h : kind) left.push_back(&h);
  }
  std::ranges::sort(left, std::greater{}, [](const Hypothesis* h) {
    return h->fit.log_likelihood;
  });
  const auto end = [&](std::size_t n, const Progress& quiet) {
    *left[n] = arrive(std::move(*left[n]), fitter, reach, quiet);
    tell(left[n]->fit);
  };
  work_on_each(left.size(), part_of(progress, 0.6, 1.0), end);
  for (const Hypothesis* h : left) reach.take(*h);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    if (plans[k].known != nullptr)
      found[k].push_back(reach.judged(*plans[k].known));
  }
  return found;
}

}  // namespace tapfit::updating
