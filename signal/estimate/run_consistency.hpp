// Whether runs of one placement, whose hits are averaged together, measured the
// same. They do not where a range was changed from file to file, a sensor moved
// or the structure warmed up, and their mean would hide it.
//
//   e_k = Y_k - H F_k,   H = H1 of all m hits
//   B = sum_r |sum_{k in r} e_k F_k*|^2 / sum_{k in r} |F_k|^2
//
// is what the FRFs of each of the R runs explain of the squares S = sum
// |e_k|^2, both from the sums over each run's hits that the average is made of
// (analysis of variance; R. A. Fisher, "Statistical Methods for Research
// Workers", 1925), and
//
//   F = (B / (R - 1)) / ((S - B) / (m - R))
//
// tells how surely. A hit that fell beside the point is wrong on all lines and
// sensors together, so it counts as one observation, not as one per line. Where
// runs are single hits little is left to compare with; so each run against the
// others and one trend, e_k = (r - mean r) G F_k, are tried, too, with 1 and
// m - 2 degrees of freedom, and the least likely of all counts, times so many
// as were tried (Bonferroni).
#pragma once

#include "acquisition/bundle/runs_alike.hpp"
#include "acquisition/foundation/finding.hpp"
#include "signal/estimate/estimator.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tapfit::signal {

struct RunInconsistency {
  enum class Kind { FromRunToRun, OneApart, Trend };

  Kind kind = Kind::FromRunToRun;
  double p_value = 1.0;  ///< how often chance gives as much
  /// Of the FRFs, relative: rms over the runs, of that one, or first to last.
  double change = 0.0;
  std::size_t run = 0;     ///< that differs most from the others, by its place
  std::size_t sensor = 0;  ///< on which
  std::optional<double> factor;  ///< nothing but that, against the others
};

/// One run's sums over its hits.
struct RunPowers {
  std::size_t place = 0;            ///< in the group
  std::vector<CrossPowers> powers;  ///< per sensor
};

/// @param runs of one placement that have hits, in order
/// @return empty where the runs agree, or too few hits tell
[[nodiscard]] std::optional<RunInconsistency> run_inconsistency(
    const std::vector<RunPowers>& runs);

/// @param group the runs that were compared
[[nodiscard]] Finding finding_of(const RunInconsistency& difference,
                                 const acquisition::TestBundle& bundle,
                                 const acquisition::RunGroup& group);

}  // namespace tapfit::signal
