#include "updating/diagnose.hpp"

#include "updating/evidence.hpp"
#include "updating/hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tapfit::updating {
namespace {

constexpr int folds = 4;
// "Positive" evidence on Kass and Raftery's scale ends at 20 : 1; explanations
// closer than that are not told apart.
const double look_alike = std::log(20.0);
// "Very strong" evidence, 150 : 1, before a rung is believed.
const double very_strong = std::log(150.0);
// A fit within this factor of the floor leaves nothing to explain.
constexpr double at_floor = 1.3;
// What an effect must lower the error on left-out runs to. Mesh and model form
// leave errors of a few percent that some effect can always shave a little.
constexpr double worth_it = 0.85;
// Beyond this there is surely more than one rung can explain.
constexpr double clear_of_floor = 3.0;
// First rungs from which a second one is tried.
constexpr int kinds_tried_first = 4;

Candidate candidate_of(const Hypothesis& h,
                       const effects::Setting& setting,
                       double probability) {
  Candidate c;
  c.effect = h.own().effect->name();
  c.where = h.own().where;
  c.parameters = effect_estimates(h.fit, h.fit.effects.size() - 1, setting);
  c.probability = probability;
  c.error = h.fit.result.error;
  return c;
}

// An effect that is in the model, as the round that chose it saw it.
struct Chosen {
  std::string name;  // its kind, or the group of kinds not told apart
  double probability = 0.0;
};

// What was found on one rung.
struct Round {
  std::vector<Hypothesis> hypotheses;
  std::vector<double> probability;
  double none_evidence = 0.0;
};

Round look(const Fit& current,
           const Fitter& fitter,
           const HypothesisOptions& options,
           const Progress& progress) {
  Round round;
  round.hypotheses = fit_hypotheses(current, fitter, options, progress);
  round.none_evidence =
      log_evidence(current.result.error, 0.0, 1.0, options.data);
  std::vector<double> evidence = {round.none_evidence};
  for (const Hypothesis& h : round.hypotheses) {
    evidence.push_back(h.log_evidence);
  }
  round.probability = probabilities(evidence);
  return round;
}

// Probability of an effect among all that was tried with it, none included.
double probability_of(const Round& round, const PlacedEffect& effect) {
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const PlacedEffect& own = round.hypotheses[k].own();
    if (own.effect == effect.effect && own.where == effect.where) {
      return round.probability[k + 1];
    }
  }
  return 0.0;
}

// Kinds whose best hypothesis is not told apart from the best of all.
std::string group_name(const Round& round) {
  std::vector<std::string> kinds;
  for (const Hypothesis& h : round.hypotheses) {
    if (round.hypotheses.front().log_evidence - h.log_evidence > look_alike) {
      break;
    }
    const std::string kind = h.own().effect->name();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
      kinds.push_back(kind);
    }
  }
  std::string name;
  for (std::size_t k = 0; k < std::min<std::size_t>(kinds.size(), 3); ++k) {
    name += (k == 0 ? "" : "|") + kinds[k];
  }
  return name;
}

std::vector<Candidate> candidates_of(const Round& round,
                                     const effects::Setting& setting) {
  std::vector<Candidate> result;
  std::map<std::string, int> shown;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& h = round.hypotheses[k];
    const std::string kind = h.own().effect->name();
    // A long list of neighbours says nothing new.
    if (++shown[kind] > 3) continue;
    Candidate c = candidate_of(h, setting, round.probability[k + 1]);
    for (const Hypothesis& other : round.hypotheses) {
      const bool close =
          std::abs(other.log_evidence - h.log_evidence) <= look_alike;
      if (close && &other != &h) {
        c.indistinguishable_from.push_back(
            {other.own().effect->name(), other.own().where});
      }
    }
    result.push_back(std::move(c));
  }
  return result;
}

// A rung must lower the error on runs that it was not fitted to, to a share of
// what it was, and do so with very strong evidence.
bool earns_its_place(const Hypothesis& best,
                     const Round& round,
                     double held_out_before,
                     double held_out_after,
                     double share) {
  return best.log_evidence - round.none_evidence > very_strong &&
         held_out_after < share * held_out_before;
}

// A first rung that leaves much may be a stand-in for two effects. Each other
// kind's best is given the chance of a second rung; the pair that leaves least
// names the first rung.
std::size_t first_of_best_pair(const Round& round,
                               const Fitter& fitter,
                               HypothesisOptions options,
                               const Progress& progress) {
  options.neighbours = 0;
  options.places_per_kind = 1;
  std::size_t best = 0;
  double least = 1e300;
  std::set<const effects::Effect*> kinds;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& h = round.hypotheses[k];
    if (static_cast<int>(kinds.size()) == kinds_tried_first) break;
    if (!kinds.insert(h.own().effect).second) continue;
    const Round next = look(h.fit, fitter, options, progress);
    if (next.hypotheses.empty()) continue;
    const double error = next.hypotheses.front().fit.result.error;
    if (error < least) {
      least = error;
      best = k;
    }
  }
  return best;
}

// Takes effects off that the others have made superfluous; the first `already`
// stay.
Fit prune(Fit fit,
          std::size_t already,
          const Fitter& fitter,
          double data,
          std::vector<Chosen>& chosen,
          const Progress& progress) {
  for (std::size_t k = already; k + 1 < fit.effects.size();) {
    std::vector<PlacedEffect> fewer = fit.effects;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    Fit without = fitter.fit(fewer, fitter.model_for(fewer), progress);
    const double own = static_cast<double>(fit.effects[k].p.size());
    const double gain = log_evidence(fit.result.error, own, 1.0, data) -
                        log_evidence(without.result.error, 0.0, 1.0, data);
    if (gain < very_strong) {
      fit = std::move(without);
      chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(k - already));
    } else {
      ++k;
    }
  }
  return fit;
}

// With several effects in, each is looked for again while the others stay: the
// first was found before the others were known.
Fit relocate(Fit fit,
             std::size_t already,
             const Fitter& fitter,
             const HypothesisOptions& options,
             std::vector<Chosen>& chosen,
             const Progress& progress) {
  for (std::size_t k = already; k + 1 < fit.effects.size(); ++k) {
    std::vector<PlacedEffect> others = fit.effects;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const Fit without = fitter.fit(others, fitter.model_for(others), progress);
    const Round round = look(without, fitter, options, progress);
    if (round.hypotheses.empty()) continue;
    const Hypothesis& best = round.hypotheses.front();
    if (best.fit.result.error >= 0.98 * fit.result.error) {
      // Now that the others are known, so is how sure this one is.
      chosen[k - already].probability =
          probability_of(round, fit.effects[k]);
      continue;
    }
    fit = best.fit;
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(k - already));
    chosen.push_back({group_name(round), round.probability[1]});
  }
  return fit;
}

// Error after each rung, in the order of the largest drop: refits with ever
// more of the effects.
std::vector<Rung> ladder_of(const Fit& fit,
                            const std::vector<Chosen>& names,
                            std::size_t already,
                            const Fitter& fitter,
                            const Progress& progress) {
  const effects::Setting& setting = fitter.setting().setting;
  std::vector<std::size_t> left;
  for (std::size_t k = already; k < fit.effects.size(); ++k) left.push_back(k);
  std::vector<PlacedEffect> so_far(
      fit.effects.begin(),
      fit.effects.begin() + static_cast<std::ptrdiff_t>(already));
  std::vector<Rung> ladder;
  while (!left.empty()) {
    double least = 1e300;
    std::size_t chosen = left.front();
    for (const std::size_t k : left) {
      if (left.size() == 1) {
        least = fit.result.error;
        break;
      }
      std::vector<PlacedEffect> tried = so_far;
      tried.push_back(fit.effects[k]);
      const Fit with = fitter.fit(tried, fitter.model_for(tried), progress);
      if (with.result.error < least) {
        least = with.result.error;
        chosen = k;
      }
    }
    Rung rung;
    rung.added = names[chosen - already].name;
    rung.probability = names[chosen - already].probability;
    rung.where = fit.effects[chosen].where;
    rung.error = least;
    rung.parameters = effect_estimates(fit, chosen, setting);
    ladder.push_back(std::move(rung));
    so_far.push_back(fit.effects[chosen]);
    left.erase(std::find(left.begin(), left.end(), chosen));
  }
  return ladder;
}

// Candidates that made it into the model are reported as fitted with all
// others, first and in the ladder's order.
void lead_with_ladder(std::vector<Candidate>& candidates,
                      const std::vector<Rung>& ladder,
                      double error) {
  for (auto rung = ladder.rbegin(); rung != ladder.rend(); ++rung) {
    const std::string kind = rung->added.substr(0, rung->added.find('|'));
    Candidate lead;
    const auto it = std::find_if(
        candidates.begin(), candidates.end(), [&](const Candidate& c) {
          return c.effect == kind && c.where == rung->where;
        });
    if (it != candidates.end()) {
      lead = *it;
      candidates.erase(it);
    }
    lead.effect = kind;
    lead.probability = rung->probability;
    lead.where = rung->where;
    lead.parameters = rung->parameters;
    lead.error = error;
    candidates.insert(candidates.begin(), lead);
  }
}

}  // namespace

Diagnosis diagnose(const Fitter& fitter,
                   const std::vector<PlacedEffect>& present,
                   const DiagnoseOptions& options,
                   const Progress& progress) {
  const effects::Setting& setting = fitter.setting().setting;
  Diagnosis result;
  result.floor = options.floor;
  result.contour = options.contour;
  Fit current = fitter.fit(present, fitter.model_for(present), progress);
  result.error_base = current.result.error;
  HypothesisOptions search;
  search.places_per_kind = options.places_per_kind;
  search.neighbours = options.neighbours;
  search.data = evidence_data(fitter.target(), options.modes_in_band);

  std::vector<Chosen> names;
  double held_out = fitter.held_out_error(current, folds, progress);
  for (int rung = 0; rung < options.max_rungs; ++rung) {
    if (rung > 0 && current.result.error <= at_floor * options.floor) break;
    const Round round = look(current, fitter, search, progress);
    if (rung == 0) result.candidates = candidates_of(round, setting);
    if (round.hypotheses.empty()) break;
    std::size_t chosen = 0;
    double share = worth_it;
    if (rung == 0 && round.hypotheses.front().fit.result.error >
                         clear_of_floor * options.floor) {
      chosen = first_of_best_pair(round, fitter, search, progress);
      // What it is worth shows on the next rung.
      share = 1.0;
    }
    const Hypothesis& best = round.hypotheses[chosen];
    const double after = fitter.held_out_error(best.fit, folds, progress);
    if (rung == 0 && chosen == 0) {
      result.candidates.front().held_out_error = after;
    }
    if (!earns_its_place(best, round, held_out, after, share)) break;
    names.push_back(
        {chosen == 0 ? group_name(round) : best.own().effect->name(),
         round.probability[chosen + 1]});
    current = best.fit;
    if (rung > 0) {
      current = relocate(std::move(current),
                         present.size(),
                         fitter,
                         search,
                         names,
                         progress);
      current = prune(std::move(current),
                      present.size(),
                      fitter,
                      search.data,
                      names,
                      progress);
    }
    held_out = fitter.held_out_error(current, folds, progress);
  }
  result.error_best = current.result.error;
  result.ladder = ladder_of(current, names, present.size(), fitter, progress);
  lead_with_ladder(result.candidates, result.ladder, result.error_best);
  result.model_parameters = property_estimates(current, options.properties);
  for (const Rung& rung : result.ladder) {
    result.verdict += (result.verdict.empty() ? "" : "+") + rung.added;
  }
  // Three times the floor, or a tenth of the base error where the floor is far
  // below what any model reaches.
  const bool explained = result.error_best <=
                         std::max(3.0 * options.floor, 0.1 * result.error_base);
  if (result.ladder.empty()) {
    result.verdict =
        result.error_base <= 3.0 * options.floor ? "none" : "unexplained";
  } else if (!explained) {
    result.warnings.push_back(fmt::format(
        "{} lowers the error from {:.3g} to {:.3g} only, far above the floor "
        "of {:.3g}: something else is missing",
        result.verdict,
        result.error_base,
        result.error_best,
        options.floor));
    result.verdict = "unexplained";
  }
  return result;
}

}  // namespace tapfit::updating
