#include "updating/robustness/refit_verdict.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/candidate_ranking.hpp"
#include "updating/diagnosis/classify_diagnosis.hpp"
#include "updating/diagnosis/evidence.hpp"
#include "updating/diagnosis/worth.hpp"
#include "updating/localisation/run_drift.hpp"
#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

// What the fits are judged by.
struct Judge {
  const Fitter& fitter;
  const DiagnoseOptions& options;
  const Progress& progress;

  [[nodiscard]] double data(const Fit& none) const {
    return independent_data(fitter.target(), none.result.residual);
  }
  [[nodiscard]] double held_out(const Fit& fit) const {
    return fitter.held_out_error(fit, held_out_folds, progress);
  }
  [[nodiscard]] Floor floor(const Fit& fit) const {
    return floor_of(fit, fitter.target(), options);
  }
  [[nodiscard]] FormShare form(const Fit& fit) const {
    return form_share(fit, fitter.target(), options.floor_noise);
  }
};

// The contenders beside none of them, as ForwardSelection::look() has them.
CandidateRanking round_of(const std::vector<Contender>& contenders,
                          const Fit& none,
                          const Judge& judge) {
  CandidateRanking round;
  round.data = judge.data(none);
  std::vector<double> of_kinds;
  for (const Contender& c : contenders) {
    round.hypotheses.push_back(c.hypothesis);
  }
  judge_hypotheses(
      round.hypotheses, none, round.data, judge.options.floor_noise);
  of_kinds.push_back(round.none_evidence());
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    of_kinds.push_back(round.hypotheses[k].log_evidence +
                       std::log(contenders[k].kind_share));
  }
  round.probability = probabilities(of_kinds);
  return round;
}

// Each stands for its kind, whose places are all in its probability.
std::size_t strongest(const CandidateRanking& round) {
  const auto none = round.probability.begin();
  const auto at = std::ranges::max_element(none + 1, round.probability.end());
  return static_cast<std::size_t>(at - none - 1);
}

// What the last effect of a fit is worth over a fit without it.
// @param first nothing else was found: what is left may be two effects' then
bool earns(const Fit& with,
           double gain,
           const Fit& none,
           bool first,
           const Judge& judge) {
  Worth worth;
  worth.gain = gain;
  if (gain <= very_strong) return false;
  const DiagnoseOptions& options = judge.options;
  const bool much = judge.form(with).left > clear_of_floor * options.floor;
  if (first && much) worth.share = 1.0;
  for_each_parallel(2, [&](std::size_t k) {
    (k == 0 ? worth.held_out : worth.with_it) =
        judge.held_out(k == 0 ? none : with);
  });
  return worth.earned();
}

// Of a rung that is in the model: the last, and with it a single one, must earn
// its place on runs left out, the others must not be superfluous.
bool stays(const CandidateRanking& round,
           std::size_t best,
           const Fit& none,
           std::size_t rung,
           std::size_t rungs,
           const Judge& judge) {
  const Hypothesis& h = round.hypotheses[best];
  const double gain = h.log_gain;
  // Beside others its place is settled and costs nothing.
  const double kept = gain + std::log(std::max(h.places, 1.0));
  if (rungs > 1 && kept < very_strong) return false;
  if (rung + 1 < rungs) return true;
  return !is_explained(none.result.error, judge.floor(none)) &&
         earns(h.fit, gain, none, rungs == 1, judge);
}

// Adds what came closest on top to the ladder where it has earned its place.
void add_beside(const Refits& refits,
                const Fit& top,
                const Judge& judge,
                Diagnosis& result) {
  if (refits.besides.empty()) return;
  if (is_explained(top.result.error, judge.floor(top))) return;
  const CandidateRanking round = round_of(refits.besides, top, judge);
  const std::size_t best = strongest(round);
  const Hypothesis& h = round.hypotheses[best];
  const double gain = h.log_gain;
  const bool first = result.ladder.empty();
  if (!earns(h.fit, gain, top, first, judge)) return;
  Rung rung;
  rung.added = group_name(round, best);
  rung.where = h.own().where;
  rung.error = h.fit.result.error;
  result.error_best = rung.error;
  result.ladder.push_back(std::move(rung));
}

// What the diagnosis says once its ladder stands.
void conclude(const Fit& top, const Judge& judge, Diagnosis& result) {
  result.floor = std::hypot(judge.options.floor, judge.form(top).error);
  classify_diagnosis(judge.fitter.problem().measured.level, {}, result);
  if (result.verdict != "none") return;
  const auto drift = run_drift(top, judge.fitter.target());
  if (drift && is_significant(*drift)) result.verdict = "unexplained";
}

}  // namespace

std::string verdict_of(const Refits& refits,
                       const Fitter& fitter,
                       const DiagnoseOptions& options,
                       const Diagnosis& before,
                       const Progress& progress) {
  const Judge judge{fitter, options, progress};
  Diagnosis result;
  result.error_base = before.error_base;
  result.error_fitted = before.error_fitted;
  const Fit* top = &refits.found;
  const std::size_t rungs = refits.instead.size();
  for (std::size_t k = 0; k < rungs; ++k) {
    const Fit& none = refits.without[k];
    const CandidateRanking round = round_of(refits.instead[k], none, judge);
    const std::size_t best = strongest(round);
    if (!stays(round, best, none, k, rungs, judge)) {
      // Of several that go the one that leaves most speaks.
      if (none.result.error > top->result.error) top = &none;
      continue;
    }
    Rung rung = before.ladder[k];
    rung.added = group_name(round, best);
    rung.where = round.hypotheses[best].own().where;
    result.ladder.push_back(std::move(rung));
  }
  result.error_best = top->result.error;
  if (!result.ladder.empty()) result.ladder.back().error = result.error_best;
  if (result.ladder.size() == rungs) add_beside(refits, *top, judge, result);
  conclude(*top, judge, result);
  return result.verdict;
}

}  // namespace tapfit::updating
