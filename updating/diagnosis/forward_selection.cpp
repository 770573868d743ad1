#include "updating/diagnosis/forward_selection.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/candidate.hpp"
#include "updating/diagnosis/effect_forms.hpp"
#include "updating/diagnosis/evidence.hpp"
#include "updating/diagnosis/settle_place.hpp"
#include "updating/diagnosis/worth.hpp"
#include "updating/effects/effect_instance.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/residual/independent_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

namespace tapfit::updating {

namespace {

// First rungs from which a second one is tried.
constexpr int kinds_tried_first = 4;
// A screened error beyond this times the least is not worth a full fit once
// the list is no longer for show: the screening is good to a few tens of
// percent.
constexpr double promising = 2.0;
// Of those that the screening puts first, in the end.
constexpr int many_joints = 80;
// An effect found again, or a weaker one put first, must be this much better
// to take the place.
constexpr double better = 0.98;

// Mistakes of the sheet are a kind for each channel: which one it is, what is
// missing besides may hide.
bool is_same_kind(const EffectInstance& one, const EffectInstance& other) {
  return one.effect == other.effect &&
         (!one.effect->at_sheet_points() ||
          one.where.channels == other.where.channels);
}

// Of the kind of one the one that leaves least, with as many parameters: what a
// second effect would explain looks like an error of form to the evidence,
// which then tells little between places.
std::size_t least_of_kind(const CandidateRanking& round, std::size_t of) {
  const Hypothesis& first = round.hypotheses[of];
  std::size_t least = of;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& h = round.hypotheses[k];
    const bool alike = is_same_kind(h.own(), first.own()) &&
                       h.own().p.size() == first.own().p.size();
    const double error = round.hypotheses[least].fit.result.error;
    if (alike && h.fit.result.error < error) least = k;
  }
  return least;
}

std::vector<EffectInstance> without(const Fit& fit, std::size_t k) {
  std::vector<EffectInstance> rest = fit.effects;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
  return rest;
}

}  // namespace

ForwardSelection::ForwardSelection(const Fitter& fitter,
                                   const DiagnoseOptions& options)
    : fitter_(&fitter), options_(options) {}

SelectedEffect ForwardSelection::as_selected(const CandidateRanking& round,
                                             std::size_t of) const {
  return {group_name(round, of),
          round.probability[of + 1],
          indistinguishable(round, of),
          patch_extent(round.hypotheses,
                       round.hypotheses[of].own(),
                       options_.floor,
                       fitter_->problem().context),
          place_sd(round, of),
          strongest_of(round, of)};
}

// How sure an effect is among all that was tried with it, none included; as
// sure as before where the round passed over it.
void ForwardSelection::judge_anew(const CandidateRanking& round,
                                  const EffectInstance& effect,
                                  SelectedEffect& it) const {
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const EffectInstance& own = round.hypotheses[k].own();
    if (own.effect != effect.effect || own.where != effect.where) continue;
    it = as_selected(round, k);
    return;
  }
}

Fit ForwardSelection::refit(const std::vector<EffectInstance>& effects,
                            const Progress& progress) const {
  return fitter_->fit(effects, fitter_->model_for(effects), progress);
}

// The same fit with one of its effects as the last.
Fit ForwardSelection::with_last(const Fit& fit,
                                std::size_t k,
                                const Progress& progress) const {
  Fit turned = fit;
  std::vector<EffectInstance>& effects = turned.result.state.effects;
  const auto own = effects.begin() + static_cast<std::ptrdiff_t>(k);
  std::rotate(own, own + 1, effects.end());
  turned.effects = effects;
  return fitter_->fit_beside(
      turned, effects, fitter_->model_for(effects), progress);
}

// Fitted anew, and going on from where it stands: an effect that does next to
// nothing is no reason to end elsewhere.
Fit ForwardSelection::without_one(const Fit& fit,
                                  std::size_t k,
                                  const Progress& progress) const {
  Fit rest = fit;
  rest.effects = without(fit, k);
  std::vector<EffectInstance>& effects = rest.result.state.effects;
  effects.erase(effects.begin() + static_cast<std::ptrdiff_t>(k));
  const auto model = fitter_->model_for(rest.effects);
  std::array<Fit, 2> fits;
  const Progress quiet{{}, progress.stop};
  for_each_parallel(fits.size(), [&](std::size_t which) {
    fits[which] = which == 0
                      ? fitter_->fit(rest.effects, model, quiet)
                      : fitter_->fit_beside(rest, rest.effects, model, quiet);
  });
  const bool anew = fits[0].result.error <= fits[1].result.error;
  return std::move(fits[anew ? 0 : 1]);
}

// The strongest evidence first.
void ForwardSelection::put_in_order(CandidateRanking& round,
                                    const Fit& current) const {
  judge_hypotheses(round.hypotheses, current, round.data, options_.floor_noise);
  std::ranges::stable_sort(
      round.hypotheses, std::greater{}, &Hypothesis::log_evidence);
}

// The probabilities of what is in order.
void ForwardSelection::weigh(CandidateRanking& round) {
  put_likeliest_kind_first(round.hypotheses);
  std::vector<double> evidence = {round.none_evidence()};
  for (const Hypothesis& h : round.hypotheses) {
    evidence.push_back(h.log_evidence);
  }
  round.probability = probabilities(evidence);
}

// Between grids the likeliest of each kind goes on where it may be the answer.
void ForwardSelection::settle_places(const Fit& current,
                                     CandidateRanking& round,
                                     const Progress& progress) const {
  // Of log evidence: what a place may gain that is half a spacing off.
  constexpr double contender = 30.0;
  std::vector<Hypothesis>& all = round.hypotheses;
  if (all.empty()) return;
  const double strongest = all.front().log_evidence;
  std::set<const effects::Effect*> kinds;
  for (std::size_t k = 0, count = all.size(); k < count; ++k) {
    if (all[k].log_evidence < strongest - contender) break;
    const bool first = kinds.insert(all[k].own().effect).second;
    if (!first || !is_at_grid(all[k].own().where)) continue;
    // Places beside each other are told apart by what is left at them.
    const double data =
        independent_data(fitter_->target(), all[k].fit.result.residual);
    Hypothesis settled = settle_place(
        all[k], current, *fitter_, {data, options_.floor_noise}, progress);
    if (settled.own().where == all[k].own().where) {
      all[k] = std::move(settled);
    } else {
      all.push_back(std::move(settled));
    }
  }
}

CandidateRanking ForwardSelection::look(const Fit& current,
                                        Depth depth,
                                        const Progress& progress,
                                        const Fit* known,
                                        const Fit* rival) const {
  const bool thorough = depth >= Depth::Thorough;
  HypothesisOptions options;
  options.places_per_kind = thorough ? options_.places_per_kind : 1;
  options.neighbours = depth == Depth::Quick ? 0 : options_.neighbours;
  options.promising = thorough ? 1e300 : promising;
  options.explained = explained_error({options_.floor, options_.floor_noise});
  if (depth == Depth::LastResort) options.joints = many_joints;
  options.known = known;
  options.rival = rival;
  options.best_of_each = thorough;
  if (depth == Depth::Thorough && options_.tried) {
    options.tried = [this](const Fit& fit) {
      options_.tried(candidate_of(fit, fitter_->problem().context));
    };
  }
  CandidateRanking round;
  round.hypotheses = fit_hypotheses(current, *fitter_, options, progress);
  // What there is to tell by is what is left so far.
  round.data = independent_data(fitter_->target(), current.result.residual);
  put_in_order(round, current);
  if (options.neighbours > 0) {
    settle_places(current, round, progress);
    put_in_order(round, current);
  }
  weigh(round);
  return round;
}

CandidateRanking ForwardSelection::with_forms(CandidateRanking round,
                                              const Fit& current,
                                              const Progress& progress) const {
  const Floor floor{options_.floor, options_.floor_noise};
  const bool explained =
      std::ranges::any_of(round.hypotheses, [&floor](const Hypothesis& h) {
        return is_explained(h.fit.result.error, floor);
      });
  if (explained) return round;
  add_forms_of_few(round.hypotheses, current, *fitter_, progress);
  put_in_order(round, current);
  weigh(round);
  return round;
}

ForwardSelection::Pair ForwardSelection::best_pair(
    const Fit& current,
    const CandidateRanking& round,
    const Progress& progress) const {
  Pair pair;
  double least = 1e300;
  std::set<const effects::Effect*> kinds;
  std::vector<const EffectInstance*> known;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const EffectInstance& own = round.hypotheses[k].own();
    const bool fresh = !kinds.contains(own.effect);
    if (fresh && static_cast<int>(kinds.size()) == kinds_tried_first) break;
    // Nothing by itself: with another it is what the other is alone.
    const bool tells = round.hypotheses[k].log_gain > 0.0;
    if (!tells && !kinds.empty()) break;
    if (std::ranges::any_of(known, [&own](const EffectInstance* one) {
          return is_same_kind(*one, own);
        })) {
      continue;
    }
    kinds.insert(own.effect);
    known.push_back(&own);
    const std::size_t first = least_of_kind(round, k);
    const Hypothesis& h = round.hypotheses[first];
    const auto tried = static_cast<double>(kinds.size());
    const Fit* rival = pair.next ? &pair.next->hypotheses.front().fit : nullptr;
    CandidateRanking next = look(h.fit,
                                 Depth::Quick,
                                 part_of(progress,
                                         (tried - 1.0) / kinds_tried_first,
                                         tried / kinds_tried_first),
                                 nullptr,
                                 rival);
    if (next.hypotheses.empty()) continue;
    const Hypothesis& second = next.hypotheses.front();
    // The same two in the other order end at the same error, but for rounding.
    if (second.fit.result.error >= better * least) continue;
    least = second.fit.result.error;
    const auto sizes =
        static_cast<double>(h.own().p.size() + second.own().p.size());
    pair.first = first;
    const double noise = options_.floor_noise;
    const double places = h.places * second.places;
    pair.gain = log_gain(evidence(second.fit, sizes, places, next.data, noise),
                         evidence(current, 0.0, 1.0, next.data, noise),
                         second.fit.result.error / current.result.error);
    pair.next = std::move(next);
  }
  return pair;
}

Fit ForwardSelection::relocate(Fit fit,
                               std::size_t already,
                               std::vector<SelectedEffect>& chosen,
                               const Progress& progress) const {
  for (std::size_t k = already; k + 1 < fit.effects.size(); ++k) {
    if (auto plain = in_plain_form(fit, k, *fitter_, progress)) {
      fit = *std::move(plain);
    }
    Fit known;
    Fit rest;
    const Progress quiet{{}, progress.stop};
    for_each_parallel(2, [&](std::size_t which) {
      if (which == 0) {
        known = with_last(fit, k, quiet);
      } else {
        rest = refit(without(fit, k), quiet);
      }
    });
    const CandidateRanking round = look(rest, Depth::Nearby, progress, &known);
    if (round.hypotheses.empty()) continue;
    const Hypothesis& best = round.hypotheses.front();
    // Masses of their own, where one for all sensors does as well.
    const bool simpler = best.own().effect == fit.effects[k].effect &&
                         best.own().p.size() < fit.effects[k].p.size();
    if (!simpler && best.fit.result.error >= better * fit.result.error) {
      // Now that the others are known, so is how sure this one is.
      judge_anew(round, fit.effects[k], chosen[k - already]);
      continue;
    }
    fit = best.fit;
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(k - already));
    chosen.push_back(as_selected(round, 0));
  }
  return fit;
}

// Fewer parameters counted.
bool ForwardSelection::is_likelier(const Fit& united, const Fit& apart) const {
  const double data =
      independent_data(fitter_->target(), apart.result.residual);
  const auto of = [&](const Fit& fit) {
    double own = 0.0;
    for (const EffectInstance& e : fit.effects) {
      own += static_cast<double>(e.p.size());
    }
    return evidence(fit, own, 1.0, data, options_.floor_noise).log;
  };
  return of(united) > of(apart);
}

Fit ForwardSelection::unite(Fit fit,
                            std::size_t already,
                            std::vector<SelectedEffect>& chosen,
                            const Progress& progress) const {
  for (std::size_t k = already; k + 1 < fit.effects.size(); ++k) {
    for (EffectInstance& whole : both_of(
             fit.effects[k], fit.effects.back(), fitter_->problem().context)) {
      std::vector<EffectInstance> effects = without(fit, k);
      effects.back() = std::move(whole);
      Fit united = refit(effects, progress);
      const bool worse = better * united.result.error > fit.result.error;
      if (worse && !is_likelier(united, fit)) continue;
      chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(k - already));
      return united;
    }
  }
  return fit;
}

// A crack in a mesh is stiffer around its tip than a real one, a clamp's edge
// softer: a loss beside it is its own.
// @param rest the fit without it
bool ForwardSelection::is_part_of_another(const Fit& fit,
                                          std::size_t k,
                                          const Fit& rest,
                                          const Progress& progress) const {
  const structure::Deck& deck = *fitter_->problem().context.deck;
  const double floor = told_floor(rest, fitter_->target(), options_);
  if (rest.result.error > at_floor * floor) return false;
  for (std::size_t j = 0; j < fit.effects.size(); ++j) {
    if (j == k || !give_way_together(fit.effects[k], fit.effects[j], deck)) {
      continue;
    }
    // Of the two the one goes that does less.
    if (j < k) return true;
    return rest.result.error <= without_one(fit, j, progress).result.error;
  }
  return false;
}

Fit ForwardSelection::prune(Fit fit,
                            std::size_t already,
                            double data,
                            std::vector<SelectedEffect>& chosen,
                            const Progress& progress) const {
  for (std::size_t k = already;
       k < fit.effects.size() && fit.effects.size() > already + 1;) {
    Fit rest = without_one(fit, k, progress);
    const double own = static_cast<double>(fit.effects[k].p.size());
    // As many places as when it was added.
    const std::vector<MadeFit>& tried = chosen[k - already].tried;
    const double places = tried.empty() ? 1.0 : tried.front().places;
    const double noise = options_.floor_noise;
    const double gain = log_gain(evidence(fit, own, places, data, noise),
                                 evidence(rest, 0.0, 1.0, data, noise),
                                 fit.result.error / rest.result.error);
    if (gain < very_strong || !is_told(fit, k) ||
        is_part_of_another(fit, k, rest, progress)) {
      fit = std::move(rest);
      chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(k - already));
    } else {
      ++k;
    }
  }
  return fit;
}

}  // namespace tapfit::updating
