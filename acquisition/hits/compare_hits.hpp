// What hits of one placement say about each other.
#pragma once

#include "acquisition/hits/hammer_pulses.hpp"
#include "acquisition/hits/hits.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

[[nodiscard]] bool any_accepted(const std::vector<Hit>& hits);

/// Whether a peak is below 15 % of the median of others; never with fewer than
/// three others.
[[nodiscard]] bool is_weak(double peak_n, const std::vector<double>& others);

/// ln of the RMS response per force impulse, per sensor of the run, over the
/// first eighth of the hit's block.
[[nodiscard]] Eigen::VectorXd response_per_impulse(const Run& run,
                                                   const Recording& recording,
                                                   const HammerSignal& hammer,
                                                   const Hit& hit,
                                                   const HitSet& set);

/// Whether a hit's levels differ from the median of all by more than a factor
/// of 1.6 and 6 robust standard deviations on any sensor; never with fewer than
/// three rows.
///
/// A second blow of share p, which the levels know nothing of, makes them
/// larger or smaller by factors of 1 - p to 1 + p at most.
///
/// @param level of the hit, per sensor
/// @param levels all hits x sensors, the hit's own among them
/// @param second share of the hit's second blow; 0: there is none
[[nodiscard]] bool is_outlier(const Eigen::RowVectorXd& level,
                              const Eigen::MatrixXd& levels,
                              double second);

/// Of the hit's second blow; 0: there is none.
[[nodiscard]] double second_share(const Hit& hit);

/// Judges hits out as weak that have less than 15 % of the median peak of the
/// accepted ones; needs three of those.
void judge_weak(std::vector<Hit>& hits);

/// A run whose hits are compared with those of its like.
struct ComparedRun {
  Run run;  ///< sensors in the same order in all that are compared
  const Recording* recording = nullptr;
  const HammerSignal* hammer = nullptr;
  std::vector<Hit>* hits = nullptr;
};

/// Judges accepted hits out whose response per force impulse differs from the
/// median of all by more than a factor of 1.6 and 6 robust standard deviations,
/// on any sensor; needs three accepted hits. The first eighth of the block
/// decides, since later what an earlier blow left counts for more.
///
/// @param runs of one placement
void judge_outliers(const std::vector<ComparedRun>& runs, const HitSet& set);

/// In a run without any accepted hit, accepts the strongest that is merely
/// weak (10 times the noise at least), soft, an outlier or double within its
/// block; says so, or that there is none.
///
/// @param noise of the hammer channel [N]
void keep_best_rejected(const Run& run,
                        double noise,
                        std::vector<Hit>& hits,
                        std::vector<std::string>& statements);

}  // namespace tapfit::acquisition
