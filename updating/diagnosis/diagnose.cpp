#include "updating/diagnosis/diagnose.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/candidate.hpp"
#include "updating/diagnosis/error_ladder.hpp"
#include "updating/diagnosis/likeliest_fit.hpp"
#include "updating/diagnosis/made_fit.hpp"
#include "updating/diagnosis/next_measurement.hpp"
#include "updating/diagnosis/rung_search.hpp"
#include "updating/diagnosis/set_up_mistakes.hpp"
#include "updating/diagnosis/set_verdict.hpp"
#include "updating/diagnosis/worth.hpp"
#include "updating/fit/held_back.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/localisation/run_drift.hpp"
#include "updating/residual/independent_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tapfit::updating {
namespace {

std::vector<Candidate> candidates_of(const Round& round,
                                     const effects::Setting& setting) {
  std::vector<Candidate> result;
  std::map<std::string, int> shown;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& h = round.hypotheses[k];
    const std::string kind = h.own().effect->name();
    // A long list of neighbours says nothing new.
    if (++shown[kind] > 3) continue;
    Candidate c = candidate_of(h.fit, setting);
    c.probability = round.probability[k + 1];
    c.indistinguishable_from = look_alikes(round, k);
    result.push_back(std::move(c));
  }
  return result;
}

// The strongest look-alike of another kind, or of the same kind elsewhere.
const EffectRef& rival_of(const Rung& rung) {
  const auto other = std::find_if(
      rung.alike.begin(), rung.alike.end(), [&rung](const EffectRef& ref) {
        return ref.effect != leading_kind(rung);
      });
  return other == rung.alike.end() ? rung.alike.front() : *other;
}

// What would tell each rung from its strongest look-alike, everything else
// being in the model. Two mistakes of the set-up foretell the same of a point
// measured anew: the sheet, not another point, is to be looked at.
std::vector<NextMeasurement> next_measurements(const Fit& fit,
                                               const std::vector<Rung>& ladder,
                                               const Fitter& fitter,
                                               const Progress& progress) {
  std::vector<NextMeasurement> result;
  for (const Rung& rung : ladder) {
    if (rung.alike.empty()) continue;
    std::vector<PlacedEffect> effects = fit.effects;
    const auto own = std::find_if(
        effects.begin(), effects.end(), [&rung](const PlacedEffect& e) {
          return e.effect->name() == leading_kind(rung) &&
                 e.where == rung.where;
        });
    if (own == effects.end()) continue;
    std::rotate(own, own + 1, effects.end());
    const auto fit_last = [&](const PlacedEffect& last) {
      effects.back() = last;
      return fitter.fit(effects, fitter.model_for(effects), progress);
    };
    const EffectRef& rival = rival_of(rung);
    if (effects.back().effect->is_mistake() &&
        effects::find(rival.effect).is_mistake()) {
      continue;
    }
    const Fit one = fit_last(effects.back());
    const Fit other = fit_last(placed(
        effects::find(rival.effect), rival.where, fitter.setting().setting));
    if (const auto next = next_measurement(one, other, fitter)) {
      result.push_back(*next);
    }
  }
  return result;
}

// The climb of the error ladder: what is in the model so far, and why.
class Climb {
 public:
  Climb(const Fitter& fitter,
        const std::vector<PlacedEffect>& present,
        const DiagnoseOptions& options,
        const Progress& progress)
      : fitter_(&fitter),
        options_(options),
        search_(fitter, options),
        already_(present.size()),
        current_(fitter.fit(present, fitter.model_for(present), progress)),
        base_error_(current_.result.error),
        held_out_(fitter.held_out_error(current_, held_out_folds, progress)) {}

  /// Adds the best effect that earns its place; false where none does.
  bool step(bool first, const Progress& progress);
  /// Takes back a first effect that was added for what it is worth beside
  /// another, where no other followed.
  void settle();

  [[nodiscard]] const Fit& current() const { return current_; }
  [[nodiscard]] double held_out_error() const { return held_out_; }
  /// @param likeliest what is in the model, with the parameters to be told
  [[nodiscard]] std::vector<Rung> ladder(const Fit& likeliest,
                                         const Progress& progress) const {
    return ladder_of(likeliest, chosen_, already_, *fitter_, progress);
  }
  [[nodiscard]] const std::vector<Chosen>& chosen() const { return chosen_; }
  /// The strongest that did not earn their place on top.
  [[nodiscard]] const std::vector<MadeFit>& passed_over() const {
    return passed_over_;
  }
  /// Everything tried on the first step.
  [[nodiscard]] std::vector<Candidate> candidates() const {
    return candidates_;
  }

 private:
  bool try_to_add(bool first,
                  RungSearch::Depth depth,
                  const Progress& progress);
  // Where a climb stands.
  struct Stand {
    Fit fit;
    double held_out = 0.0;
  };

  // Which of the round to add, what it must be worth, and what comes after it
  // where that was looked at.
  struct Choice {
    std::size_t best = 0;
    Worth worth;
    std::optional<Round> next;
  };
  [[nodiscard]] Choice choose(const Round& round,
                              bool first,
                              const Progress& progress) const;
  [[nodiscard]] FormShare form_of(const Fit& fit) const {
    return form_share(fit, fitter_->target(), options_.floor_noise);
  }
  [[nodiscard]] Floor floor() const {
    return floor_of(current_, fitter_->target(), options_);
  }
  // More than noise, mesh and form explain.
  [[nodiscard]] bool leaves_much(const Fit& fit) const {
    return form_of(fit).left > clear_of_floor * options_.floor;
  }
  // Where the verdict would have to say so.
  [[nodiscard]] bool is_left_unexplained() const {
    const double floor = std::hypot(options_.floor, form_of(current_).error);
    return leaves_much(current_) &&
           is_unexplained(
               current_.result.error, floor, base_error_, !chosen_.empty());
  }

  const Fitter* fitter_;
  DiagnoseOptions options_;
  RungSearch search_;
  std::size_t already_;
  Fit current_;
  double base_error_;
  double held_out_;
  std::optional<Stand> before_pair_;
  std::optional<Round> next_;  // a quick look from where the climb stands
  std::vector<Chosen> chosen_;
  std::vector<Candidate> candidates_;
  std::vector<MadeFit> passed_over_;
};

Climb::Choice Climb::choose(const Round& round,
                            bool first,
                            const Progress& progress) const {
  Worth worth;
  worth.held_out = held_out_;
  worth.share = share_to_reach(current_.result.error, floor());
  worth.gain = round.hypotheses[0].log_evidence - round.none_evidence;
  if (!first || !leaves_much(round.hypotheses.front().fit))
    return {0, worth, {}};
  // What it is worth shows on the next rung.
  RungSearch::Pair pair = search_.best_pair(current_, round, progress);
  worth.share = 1.0;
  worth.gain = std::max(worth.gain, pair.gain);
  return {pair.first, worth, std::move(pair.next)};
}

bool Climb::step(bool first, const Progress& progress) {
  // At the floor there is nothing to explain; on the first rung the candidates
  // are still worked out for show.
  if (!first && is_explained(current_.result.error, floor())) return false;
  using Depth = RungSearch::Depth;
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
  if (follows_the_force(fitter_->setting().measured.level, left)) return false;
  const auto drift = run_drift(current_, fitter_->target());
  if (drift && is_telling(*drift)) return false;
  return try_to_add(first, Depth::LastResort, part_of(progress, 0.9, 1.0));
}

void Climb::settle() {
  if (!before_pair_) return;
  current_ = std::move(before_pair_->fit);
  held_out_ = before_pair_->held_out;
  chosen_.clear();
}

bool Climb::try_to_add(bool first,
                       RungSearch::Depth depth,
                       const Progress& progress) {
  const bool known = next_ && depth == RungSearch::Depth::Quick;
  const Round round =
      known ? *std::exchange(next_, std::nullopt)
            : search_.look(current_, depth, part_of(progress, 0.0, 0.75));
  const Progress rest = part_of(progress, 0.75, 1.0);
  if (first) candidates_ = candidates_of(round, fitter_->setting().setting);
  if (round.hypotheses.empty()) return false;
  passed_over_ = strongest_of(round, 0);
  if (is_explained(current_.result.error, floor())) return false;
  auto [best, worth, next] = choose(round, first, rest);
  const Hypothesis& added = round.hypotheses[best];
  worth.with_it = fitter_->held_out_error(added.fit, held_out_folds, rest);
  if (first && best == 0) candidates_.front().held_out_error = worth.with_it;
  if (!worth.earned()) return false;
  worth.gain = added.log_evidence - round.none_evidence;
  worth.share = share_to_reach(current_.result.error, floor());
  before_pair_.reset();  // a second followed
  if (!worth.earned()) before_pair_ = {current_, held_out_};
  passed_over_.clear();
  chosen_.push_back(search_.as_chosen(round, best));
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

// The form's share of what a fit leaves stands in the floor.
void allow_for_form(const Fit& fit, const FormShare& form, Diagnosis& result) {
  result.form_sd = form.sd;
  result.form_error = form.error;
  result.floor = std::hypot(result.floor, form.error);
  constexpr double much = 0.5;
  if (form.error < much * fit.result.error) return;
  result.warnings.push_back(fmt::format(
      "of the {:.3g} that is left {:.3g} is what a deck that is wrong in form "
      "leaves: frequencies off by {:.2g} % (standard deviation), shapes "
      "likewise",
      fit.result.error,
      form.error,
      100.0 * form.sd));
}

void warn_of_bounds(Diagnosis& result) {
  for (const Rung& rung : result.ladder) {
    for (const Estimate& e : rung.parameters) {
      if (!e.at_bound) continue;
      result.warnings.push_back(
          rung.added + " " + e.name +
          " ended at its bound: the fit would go on, and what was found beside "
          "it may only make up for that");
      break;
    }
  }
}

// For each rung of the ladder what was tried in its place.
std::vector<std::vector<MadeFit>> tried_for(const std::vector<Rung>& ladder,
                                            const Climb& climb) {
  const std::vector<PlacedEffect>& all = climb.current().effects;
  const std::vector<Chosen>& chosen = climb.chosen();
  const std::size_t already = all.size() - chosen.size();
  std::vector<std::vector<MadeFit>> tried;
  for (const Rung& rung : ladder) {
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const PlacedEffect& own = all[already + k];
      if (own.effect->name() != leading_kind(rung)) continue;
      if (own.where == rung.where) tried.push_back(chosen[k].tried);
    }
  }
  return tried;
}

// The error ladder of the FRFs that a fitter has, and the fit at its top.
struct Climbed {
  Diagnosis diagnosis;
  Fit top;
};

Climbed climbed(const Fitter& fitter,
                const std::vector<PlacedEffect>& present,
                const DiagnoseOptions& options,
                const Progress& progress) {
  Climb climb(fitter, present, options, part_of(progress, 0.0, 0.05));
  Diagnosis result;
  result.floor = options.floor;
  result.contour = options.contour;
  result.warnings = fitter.setting().measured.statements;
  result.error_base = climb.current().result.error;
  result.error_fitted = result.error_base;
  // Whether another rung follows is not known: each gets a good part of what is
  // left, the first, which looks deepest, the most of all.
  double done = 0.05;
  for (int rung = 0; rung < options.max_rungs; ++rung) {
    const double next = done + 0.75 * (0.95 - done);
    const Progress part = part_of(progress, done, next);
    if (!climb.step(rung == 0, numbered(part, "rung", rung + 1))) break;
    done = next;
  }
  climb.settle();
  const Fit& found = climb.current();
  result.error_best = found.result.error;
  const double data = independent_data(fitter.target(), found.result.residual);
  const FormShare form =
      form_share(found, fitter.target(), options.floor_noise);
  allow_for_form(found, form, result);
  const Progress last = part_of(progress, 0.95, 1.0);
  last("error ladder", 0.0);
  const Fit likeliest =
      likeliest_fit(found, fitter, {data, options.floor_noise});
  result.ladder = climb.ladder(likeliest, last);
  result.rivals = {
      as_made(found), tried_for(result.ladder, climb), climb.passed_over()};
  result.candidates = climb.candidates();
  result.next = next_measurements(found, result.ladder, fitter, last);
  lead_with_ladder(result.candidates,
                   result.ladder,
                   result.error_best,
                   climb.held_out_error());
  result.model_parameters = property_estimates(likeliest, options.properties);
  result.model_form = model_form(likeliest, *fitter.setting().setting.deck);
  warn_of_bounds(result);
  for (const Chosen& it : climb.chosen()) {
    if (it.extent) result.warnings.push_back(statement(*it.extent));
  }
  const auto fitted =
      all_estimates(found, options.properties, fitter.setting().setting);
  set_verdict(fitter.setting().measured.level,
              held_back(options.properties, fitted),
              result);
  if (result.verdict == "none" &&
      may_hide_effect(result.error_best,
                      floor_of(found, fitter.target(), options))) {
    result.warnings.push_back(fmt::format(
        "{:.3g} is left, far above the noise ({:.3g}) and below what mesh and "
        "form may explain (the floor is {:.3g}): an effect may hide there, and "
        "the values of the model's own parameters make up for it; a finer mesh "
        "would tell more",
        result.error_best,
        options.floor_noise,
        result.floor));
  }
  return {std::move(result), found};
}

}  // namespace

Diagnosis diagnose(const Fitter& fitter,
                   const std::vector<PlacedEffect>& present,
                   const DiagnoseOptions& options,
                   const Progress& progress) {
  const Progress whole = never_falling(progress);
  Climbed ladder = climbed(fitter, present, options, whole);
  Diagnosis result = std::move(ladder.diagnosis);
  if (const auto drift = run_drift(ladder.top, fitter.target());
      drift && is_telling(*drift)) {
    result.warnings.push_back(statement(*drift));
    if (result.verdict == "none") result.verdict = "unexplained";
  }
  result.set_up =
      set_up_mistakes(result.ladder, *fitter.setting().setting.bundle);
  for (const SetUpMistake& mistake : result.set_up) {
    result.warnings.push_back(describe(mistake));
  }
  whole("error ladder", 1.0);
  return result;
}

}  // namespace tapfit::updating
