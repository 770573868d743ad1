// What was found on one rung: hypotheses beside each other, and which of them
// are not told apart.
#pragma once

#include "updating/diagnosis/rivals.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/search/hypotheses.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::updating {

struct CandidateRanking {
  /// The likeliest of the likeliest kind, then the strongest evidence first.
  std::vector<Hypothesis> hypotheses;
  std::vector<double> probability;  ///< of none, then of each hypothesis
  double data = 1.0;  ///< independent data that the evidence counts

  /// That nothing is added, on the scale of the others' evidence.
  [[nodiscard]] double none_evidence() const;
};

/// Evidence and gain of each over leaving it out.
/// @param noise relative error that the scatter over hits alone would give
void judge_hypotheses(std::vector<Hypothesis>& all,
                      const Fit& without,
                      double data,
                      double noise);

/// Explanations closer than this in log evidence, or in what of it the data say
/// where each sits best, are not told apart: 20 : 1, where "positive" evidence
/// ends on Kass and Raftery's scale.
extern const double log_odds_told_apart;

/// A kind is as probable as all its places together: puts first the likeliest
/// place of the kind that is. Of equal kinds the one with the likeliest place.
/// @param all strongest evidence first
void put_likeliest_kind_first(std::vector<Hypothesis>& all);

/// Its kind and those that are not told apart from it, joined with "|"; at most
/// three.
[[nodiscard]] std::string group_name(const CandidateRanking& round,
                                     std::size_t of);

/// The other hypotheses that are not told apart from one: their evidence is, or
/// they say the same of all that was measured with no more parameters.
[[nodiscard]] std::vector<EffectRef> indistinguishable(
    const CandidateRanking& round, std::size_t of);

/// What is not known of a place widens what is said of the size: around it, as
/// it was settled, and over all grids that were fitted where it is worth more
/// than nothing, as probable as they are.
/// @return of the logarithm of each parameter
[[nodiscard]] std::vector<double> place_sd(const CandidateRanking& round,
                                           std::size_t of);

/// One hypothesis of the round, then the best of each other kind, the strongest
/// first; few.
/// @param first its place in the round, which is not empty
[[nodiscard]] std::vector<MadeFit> strongest_of(const CandidateRanking& round,
                                                std::size_t first);

}  // namespace tapfit::updating
