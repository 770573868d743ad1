#include "updating/diagnosis/candidate_ranking.hpp"

#include "updating/diagnosis/evidence.hpp"
#include "updating/diagnosis/made_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tapfit::updating {

const double log_odds_told_apart = std::log(20.0);

namespace {

// Whether two explanations say the same of all that was measured. Their
// evidence may still differ by the number of places that were looked at.
bool predict_alike(const Hypothesis& a, const Hypothesis& b) {
  constexpr double same = 0.1;
  const Eigen::VectorXd& ra = a.fit.result.residual;
  const Eigen::VectorXd& rb = b.fit.result.residual;
  return ra.size() == rb.size() && ra.size() > 0 &&
         (ra - rb).norm() <= same * std::min(ra.norm(), rb.norm());
}

// What the data say of it, its place given: in how many others it was looked
// for is no datum.
double told_by_data(const Hypothesis& h) {
  return h.log_evidence + std::log(std::max(h.places, 1.0));
}

// A law with more parameters may contain the simpler one.
bool is_rival(const Hypothesis& other, const Hypothesis& of) {
  const double apart = std::abs(told_by_data(other) - told_by_data(of));
  return apart <= log_odds_told_apart ||
         (other.own().p.size() <= of.own().p.size() &&
          predict_alike(other, of));
}

// Kinds besides the one in question. What is weaker than these can hardly come
// first when a prior is changed by a factor of two.
constexpr std::size_t other_kinds = 3;

using KindProbability = std::map<const effects::Effect*, double>;

MadeFit contender(const CandidateRanking& round,
                  std::size_t of,
                  const KindProbability& whole) {
  const Hypothesis& h = round.hypotheses[of];
  MadeFit made = as_made(h.fit);
  made.places = h.places;
  const double own = round.probability[of + 1];
  if (own > 0.0) made.kind_share = whole.at(h.own().effect) / own;
  return made;
}

}  // namespace

double CandidateRanking::none_evidence() const {
  if (hypotheses.empty()) return 0.0;
  const Hypothesis& first = hypotheses.front();
  return first.log_evidence - first.log_gain;
}

void judge_hypotheses(std::vector<Hypothesis>& all,
                      const Fit& without,
                      double data,
                      double noise) {
  const Evidence none = evidence(without, 0.0, 1.0, data, noise);
  for (Hypothesis& h : all) {
    const auto own = static_cast<double>(h.own().p.size());
    const Evidence with = evidence(h.fit, own, h.places, data, noise);
    h.log_evidence = with.log;
    h.log_gain =
        log_gain(with, none, h.fit.result.error / without.result.error);
  }
}

void put_likeliest_kind_first(std::vector<Hypothesis>& all) {
  if (all.empty()) return;
  std::vector<double> evidence;
  for (const Hypothesis& h : all) evidence.push_back(h.log_evidence);
  const std::vector<double> probability = probabilities(evidence);
  KindProbability whole;
  for (std::size_t k = 0; k < all.size(); ++k) {
    whole[all[k].own().effect] += probability[k];
  }
  const auto of_kind = [&](const Hypothesis& h) {
    return whole.at(h.own().effect);
  };
  const auto first = std::ranges::max_element(all, {}, of_kind);
  std::rotate(all.begin(), first, first + 1);
}

// A kind is as probable as all its places together, and not told apart where
// either that is close or the data at its best place. A law with more
// parameters at the same place contains the simpler one and is no rival of it
// unless its evidence is better.
std::string group_name(const CandidateRanking& round, std::size_t of) {
  struct Kind {
    std::string name;
    double probability = 0.0;
    bool alike = false;  // one of its places says the same
  };
  const Hypothesis& own = round.hypotheses[of];
  std::vector<Kind> kinds{{own.own().effect->name()}};
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& h = round.hypotheses[k];
    const bool contains = h.own().where == own.own().where &&
                          h.own().p.size() > own.own().p.size();
    if (contains) continue;
    const std::string name = h.own().effect->name();
    auto it = std::ranges::find(kinds, name, &Kind::name);
    if (it == kinds.end()) it = kinds.insert(kinds.end(), {name});
    it->probability += round.probability[k + 1];
    it->alike = it->alike ||
                told_by_data(h) > told_by_data(own) - log_odds_told_apart ||
                (k != of && h.own().p.size() <= own.own().p.size() &&
                 predict_alike(h, own));
  }
  const double least =
      kinds.front().probability * std::exp(-log_odds_told_apart);
  std::erase_if(kinds, [&](const Kind& kind) {
    return &kind != &kinds.front() && !kind.alike && kind.probability <= least;
  });
  std::stable_sort(
      kinds.begin() + 1, kinds.end(), [](const Kind& a, const Kind& b) {
        return a.probability > b.probability;
      });
  std::string group = kinds.front().name;
  for (std::size_t k = 1; k < std::min<std::size_t>(kinds.size(), 3); ++k) {
    group += "|" + kinds[k].name;
  }
  return group;
}

std::vector<EffectRef> indistinguishable(const CandidateRanking& round,
                                         std::size_t of) {
  std::vector<EffectRef> alike;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const Hypothesis& other = round.hypotheses[k];
    if (k == of || !is_rival(other, round.hypotheses[of])) continue;
    alike.push_back({other.own().effect->name(), other.own().where});
  }
  return alike;
}

std::vector<double> place_sd(const CandidateRanking& round, std::size_t of) {
  const Hypothesis& own = round.hypotheses[of];
  std::vector<double> sd = own.place_sd;
  if (!is_at_grid(own.own().where)) return sd;
  sd.resize(own.own().p.size());
  std::vector<double> square(sd.size());
  double weight = 0.0;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    const EffectInstance& other = round.hypotheses[k].own();
    if (other.effect != own.own().effect ||
        other.where.variant != own.own().where.variant) {
      continue;
    }
    // Where it is worth nothing its size says nothing of that elsewhere.
    if (k != of && round.hypotheses[k].log_gain <= 0.0) continue;
    const double w = round.probability[k + 1];
    weight += w;
    for (std::size_t j = 0; j < sd.size(); ++j) {
      square[j] += w * std::pow(std::log(other.p[j] / own.own().p[j]), 2);
    }
  }
  for (std::size_t j = 0; j < sd.size(); ++j) {
    sd[j] = std::max(sd[j], std::sqrt(square[j] / std::max(weight, 1e-300)));
  }
  return sd;
}

std::vector<MadeFit> strongest_of(const CandidateRanking& round,
                                  std::size_t first) {
  KindProbability whole;
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    whole[round.hypotheses[k].own().effect] += round.probability[k + 1];
  }
  std::vector<MadeFit> result{contender(round, first, whole)};
  std::vector<const effects::Effect*> seen{
      round.hypotheses[first].own().effect};
  for (std::size_t k = 0; k < round.hypotheses.size(); ++k) {
    if (seen.size() > other_kinds) break;
    const effects::Effect* kind = round.hypotheses[k].own().effect;
    if (std::ranges::find(seen, kind) != seen.end()) continue;
    seen.push_back(kind);
    result.push_back(contender(round, k, whole));
  }
  return result;
}

}  // namespace tapfit::updating
