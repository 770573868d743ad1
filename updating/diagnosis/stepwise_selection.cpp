#include "updating/diagnosis/stepwise_selection.hpp"

#include "updating/diagnosis/candidate.hpp"
#include "updating/diagnosis/made_fit.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/localisation/run_drift.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace tapfit::updating {
namespace {

std::vector<Candidate> candidates_of(const CandidateRanking& round,
                                     const effects::TestContext& context) {
  std::vector<Candidate> result;
  std::map<std::string, int> shown;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& h = round.hypotheses[k];
    const std::string kind = h.own().effect->name();
    // A long list of neighbours says nothing new.
    if (++shown[kind] > 3) continue;
    Candidate c = candidate_of(h.fit, context);
    c.probability = round.probability[k + 1];
    c.indistinguishable_from = indistinguishable(round, k);
    result.push_back(std::move(c));
  }
  return result;
}

}  // namespace

StepwiseSelection::Choice StepwiseSelection::choose(
    const CandidateRanking& round, bool first, const Progress& progress) const {
  Worth worth;
  worth.held_out = held_out_;
  worth.gain = round.hypotheses[0].log_gain;
  if (!first || !leaves_much(round.hypotheses.front().fit))
    return {0, worth, {}};
  // What it is worth shows on the next rung.
  ForwardSelection::Pair pair = search_.best_pair(current_, round, progress);
  worth.share = 1.0;
  worth.gain = std::max(worth.gain, pair.gain);
  return {pair.first, worth, std::move(pair.next)};
}

bool StepwiseSelection::step(bool first, const Progress& progress) {
  // At the floor there is nothing to explain; on the first rung the candidates
  // are still worked out for show.
  if (!first && is_explained(current_.result.error, floor())) return false;
  using Depth = ForwardSelection::Depth;
  if (try_to_add(first,
                 first ? Depth::Thorough : Depth::Quick,
                 part_of(progress, 0.0, 0.9))) {
    return true;
  }
  // What the screening passes over is looked at before much is left
  // unexplained. What changes with the force or from run to run is no linear
  // effect's.
  const double left = current_.result.error;
  if (!is_left_unexplained()) return false;
  if (follows_the_force(fitter_->problem().measured.level, left)) return false;
  const auto drift = run_drift(current_, fitter_->target());
  if (drift && is_significant(*drift)) return false;
  return try_to_add(first, Depth::LastResort, part_of(progress, 0.9, 1.0));
}

void StepwiseSelection::settle() {
  if (!before_pair_) return;
  current_ = std::move(before_pair_->fit);
  held_out_ = before_pair_->held_out;
  chosen_.clear();
}

bool StepwiseSelection::try_to_add(bool first,
                                   ForwardSelection::Depth depth,
                                   const Progress& progress) {
  const bool quick = depth == ForwardSelection::Depth::Quick;
  CandidateRanking round =
      next_ && quick
          ? *std::exchange(next_, std::nullopt)
          : search_.look(current_, depth, part_of(progress, 0.0, 0.75));
  if (quick) {
    round = search_.with_forms(std::move(round), current_, progress);
  }
  const Progress rest = part_of(progress, 0.75, 1.0);
  if (first) candidates_ = candidates_of(round, fitter_->problem().context);
  if (round.hypotheses.empty()) return false;
  passed_over_ = strongest_of(round, 0);
  if (is_explained(current_.result.error, floor())) return false;
  auto [best, worth, next] = choose(round, first, rest);
  const Hypothesis& added = round.hypotheses[best];
  worth.with_it = fitter_->held_out_error(added.fit, held_out_folds, rest);
  if (first && best == 0) candidates_.front().held_out_error = worth.with_it;
  // Of two that are right together either may leave more than the properties do
  // that make up for both.
  Worth together = worth;
  if (next) {
    const Fit& both = next->hypotheses.front().fit;
    together.with_it = std::min(
        worth.with_it, fitter_->held_out_error(both, held_out_folds, rest));
  }
  if (!together.earned() || !is_told(added.fit)) return false;
  worth.gain = added.log_gain;
  worth.share = worth_it;
  before_pair_.reset();  // a second followed
  if (!worth.earned()) before_pair_ = {current_, held_out_};
  passed_over_.clear();
  chosen_.push_back(search_.as_selected(round, best));
  if (best != 0) {
    chosen_.back().name = added.own().effect->name();
    chosen_.back().alike.clear();
  }
  current_ = added.fit;
  next_ = std::move(next);
  if (!first) {
    current_ = search_.unite(std::move(current_), already_, chosen_, rest);
    current_ = search_.relocate(std::move(current_), already_, chosen_, rest);
    current_ =
        search_.prune(std::move(current_), already_, round.data, chosen_, rest);
  }
  held_out_ = fitter_->held_out_error(current_, held_out_folds, rest);
  return true;
}

}  // namespace tapfit::updating
