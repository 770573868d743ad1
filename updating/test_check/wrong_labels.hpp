// Runs whose driving point is one for another sensor: two channels exchanged in
// that run, or a blow at another point than its label says. While the sensors
// stay, what they show of each mode beside each other is the same whatever is
// hit (modal/checks/run_residues.hpp): so it is where the blow's label is
// wrong, and is not where two channels are exchanged in some runs. Exchanged in
// all of them they show at every driving point of theirs.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "signal/checks/frf_checks.hpp"

#include <cstddef>
#include <set>
#include <vector>

namespace tapfit::updating {

struct WrongLabels {
  std::set<std::size_t> channels;  ///< runs in which two are exchanged
  std::set<std::size_t> blows;     ///< runs whose blow was elsewhere
};

/// @param residues run_residue_findings()
/// @param points driving points; those that another sensor explains are given
///   the label that is wrong
[[nodiscard]] WrongLabels wrong_labels(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& set,
    const std::vector<Finding>& residues,
    std::vector<signal::DrivingPoint>& points);

/// The findings without the runs that exchanged channels explain.
[[nodiscard]] std::vector<Finding> without_exchanged(
    std::vector<Finding> residues, const WrongLabels& labels);

}  // namespace tapfit::updating
