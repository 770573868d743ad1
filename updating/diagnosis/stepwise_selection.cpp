#include "updating/diagnosis/stepwise_selection.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/diagnosis/candidate.hpp"
#include "updating/diagnosis/classify_diagnosis.hpp"
#include "updating/diagnosis/evidence.hpp"
#include "updating/diagnosis/made_fit.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/localisation/run_drift.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace tapfit::updating {
namespace {

// Their errors are to be told, beside that of the model with and without them.
std::vector<Candidate> candidates_of(const CandidateRanking& round,
                                     const Fitter& fitter,
                                     const Progress& progress) {
  std::vector<std::size_t> shown;
  std::map<std::string, int> of_kind;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    // A long list of neighbours says nothing new.
    if (++of_kind[round.hypotheses[k].own().effect->name()] <= 3) {
      shown.push_back(k);
    }
  }
  std::vector<Candidate> result(shown.size());
  const Progress quiet{{}, progress.stop};
  for_each_parallel(shown.size(), [&](std::size_t n) {
    const std::size_t k = shown[n];
    Fit fit = fitter.settled(round.hypotheses[k].fit, quiet);
    fit.result.state.effects.back().place_sd = place_sd(round, k);
    result[n] = candidate_of(fit, fitter.problem().context);
    result[n].probability = round.probability[k + 1];
    result[n].indistinguishable_from = indistinguishable(round, k);
  });
  return result;
}

// The same effects at the same places.
bool are_alike(const std::vector<EffectInstance>& some,
               const std::vector<EffectInstance>& others) {
  return std::ranges::is_permutation(
      some, others, [](const EffectInstance& a, const EffectInstance& b) {
        return a.effect == b.effect && a.where == b.where;
      });
}

}  // namespace

Worth StepwiseSelection::by_itself(const Hypothesis& it,
                                   const Progress& progress) const {
  Worth worth;
  worth.gain = it.log_gain;
  worth.held_out = stand_.held_out;
  worth.with_it = fitter_->held_out_error(it.fit, held_out_folds, progress);
  return worth;
}

StepwiseSelection::Choice StepwiseSelection::choose(
    const CandidateRanking& round,
    const Worth& leader,
    bool first,
    const Progress& progress) const {
  Choice choice{0, leader, leader, {}};
  if (!first || !leaves_much(round.hypotheses.front().fit)) return choice;
  ForwardSelection::Pair pair = search_.best_pair(stand_.fit, round, progress);
  const Hypothesis& added = round.hypotheses[pair.first];
  if (pair.first != 0) choice.itself = by_itself(added, progress);
  // What it is worth shows on the next rung. Of two that are right together
  // either may leave more than the properties do that make up for both.
  Worth together = choice.itself;
  together.share = 1.0;
  together.gain = std::max(leader.gain, pair.gain);
  if (pair.next) {
    const Fit& both = pair.next->hypotheses.front().fit;
    together.with_it =
        std::min(together.with_it,
                 fitter_->held_out_error(both, held_out_folds, progress));
  }
  if (pair.first != 0 && !(together.earned() && is_told(added.fit))) {
    return {0, leader, leader, {}};
  }
  return {pair.first, choice.itself, together, std::move(pair.next)};
}

bool StepwiseSelection::step(bool first, const Progress& progress) {
  // At the floor there is nothing to explain; on the first rung the candidates
  // are still worked out for show.
  if (!first && is_explained(stand_.fit.result.error, floor())) return false;
  using Depth = ForwardSelection::Depth;
  if (try_to_add(first,
                 first ? Depth::Thorough : Depth::Quick,
                 part_of(progress, 0.0, 0.9))) {
    return true;
  }
  // What the screening passes over is looked at before much is left
  // unexplained. What changes with the force or from run to run is no linear
  // effect's.
  const double left = stand_.fit.result.error;
  if (!is_left_unexplained()) return false;
  if (follows_the_force(fitter_->problem().measured.level, left)) return false;
  const auto drift = run_drift(stand_.fit, fitter_->target());
  if (drift && is_significant(*drift)) return false;
  return try_to_add(first, Depth::LastResort, part_of(progress, 0.9, 1.0));
}

bool StepwiseSelection::settle() {
  if (!without_second_) return false;
  stand_ = *std::exchange(without_second_, std::nullopt);
  next_.reset();
  return !stand_.chosen.empty();
}

bool StepwiseSelection::try_to_add(bool first,
                                   ForwardSelection::Depth depth,
                                   const Progress& progress) {
  const bool quick = depth == ForwardSelection::Depth::Quick;
  CandidateRanking round =
      next_ && quick
          ? *std::exchange(next_, std::nullopt)
          : search_.look(stand_.fit, depth, part_of(progress, 0.0, 0.75));
  if (quick) {
    round = search_.with_forms(std::move(round), stand_.fit, progress);
  }
  const Progress rest = part_of(progress, 0.75, 1.0);
  if (first) candidates_ = candidates_of(round, *fitter_, rest);
  if (round.hypotheses.empty()) return false;
  stand_.passed_over = strongest_of(round, 0);
  if (is_explained(stand_.fit.result.error, floor())) return false;
  const Fit& leads = round.hypotheses.front().fit;
  const Worth leader = by_itself(round.hypotheses.front(), rest);
  if (first && has_other_runs(fitter_->target())) {
    candidates_.front().held_out_error = leader.with_it;
  }
  auto [best, itself, together, next] = choose(round, leader, first, rest);
  const Hypothesis& added = round.hypotheses[best];
  // More is asked of a pair where one effect alone does well.
  const bool told =
      without_second_ ? is_told_by_size(added.fit, added.fit.effects.size() - 1)
                      : is_told(added.fit);
  if (!together.earned() || !told) {
    // A stand-in gives way to what led first.
    if (without_second_) return false;
    auto moved = with_others_moved(round, rest);
    if (!moved) return false;
    return add(*std::move(moved), round.data, rest);
  }
  without_second_.reset();  // of one before: a second followed
  if (best != 0 && leader.earned() && is_told(leads)) {
    without_second_ = {leads, leader.with_it, {search_.as_selected(round, 0)}};
  } else if (!itself.earned()) {
    without_second_ = stand_;
  }
  Stand more{added.fit, 0.0, stand_.chosen};
  more.chosen.push_back(search_.as_selected(round, best));
  if (best != 0) {
    more.chosen.back().name = added.own().effect->name();
    more.chosen.back().alike.clear();
  }
  next_ = std::move(next);
  if (!first) {
    more.fit = search_.unite(std::move(more.fit), already_, more.chosen, rest);
    more.fit =
        search_.relocate(std::move(more.fit), already_, more.chosen, rest);
  }
  return add(std::move(more), round.data, rest);
}

bool StepwiseSelection::add(Stand more, double data, const Progress& progress) {
  more.fit =
      search_.prune(std::move(more.fit), already_, data, more.chosen, progress);
  if (are_alike(more.fit.effects, stand_.fit.effects)) return false;
  stand_ = std::move(more);
  stand_.held_out =
      fitter_->held_out_error(stand_.fit, held_out_folds, progress);
  return true;
}

std::optional<StepwiseSelection::Stand> StepwiseSelection::with_others_moved(
    const CandidateRanking& round, const Progress& progress) const {
  constexpr std::size_t kinds_tried = 3;
  const double before = stand_.fit.result.error;
  const double floor = told_floor(stand_.fit, fitter_->target(), options_);
  if (stand_.chosen.empty() || before <= at_floor * floor) return {};
  std::set<const effects::Effect*> kinds;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& h = round.hypotheses[k];
    if (!kinds.insert(h.own().effect).second) continue;
    if (kinds.size() > kinds_tried) break;
    Stand more{h.fit, 0.0, stand_.chosen};
    more.chosen.push_back(search_.as_selected(round, k));
    more.fit =
        search_.relocate(std::move(more.fit), already_, more.chosen, progress);
    const double noise = options_.floor_noise;
    const auto own = static_cast<double>(h.own().p.size());
    Worth worth;
    worth.gain = log_gain(evidence(more.fit, own, h.places, round.data, noise),
                          evidence(stand_.fit, 0.0, 1.0, round.data, noise),
                          more.fit.result.error / before);
    worth.held_out = stand_.held_out;
    worth.with_it = fitter_->held_out_error(more.fit, held_out_folds, progress);
    if (worth.earned() && is_told(more.fit)) return more;
  }
  return {};
}

}  // namespace tapfit::updating
