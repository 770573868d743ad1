// Two labels of the sheet exchanged: two sensors' channels, or the points hit
// in two runs. Every path that was measured both ways is asked again under the
// exchange: reciprocity
//
//   A_ab = g A_ba   with one factor g on all lines
//
// holds for the true labels and, but for symmetric structures, for those alone
// that call all points by other names. So two sensors exchanged look like the
// blows at their points exchanged, and a sensor that sat where another run hit
// like the blows at the two points exchanged: all that is alike is named.
//
// Source: D. J. Ewins, "Modal testing", 2nd ed. 2000, 3.9 (reciprocity).
#pragma once

#include "signal/checks/frf_checks.hpp"
#include "signal/checks/frf_findings.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::signal {

/// Of two channels, or of the points hit in two runs.
struct ExchangedLabels {
  bool hits = false;
  std::size_t one = 0;  ///< channel or run
  std::size_t other = 0;
  /// Indices of the pairs that differ as they are labelled, and no more then.
  std::vector<std::size_t> explained;
};

/// Exchanges after which all paths that they are part of are reciprocal but for
/// a factor and all driving points are some, where not all of them are as
/// labelled. Most explained first.
///
/// @param pairs reciprocals() of the set
[[nodiscard]] std::vector<ExchangedLabels> exchanged_labels(
    const FrfSet& set, const std::vector<Reciprocal>& pairs);

/// One for each set of pairs that is explained; exchanges that explain the same
/// are named together.
[[nodiscard]] std::vector<Finding> exchange_findings(
    const acquisition::TestBundle& bundle,
    const FrfSet& set,
    const std::vector<Reciprocal>& pairs,
    const std::vector<ExchangedLabels>& exchanges);

/// Whether the exchange gives the FRF another label.
[[nodiscard]] bool is_of(const ExchangedLabels& exchange, const Frf& frf);

}  // namespace tapfit::signal
