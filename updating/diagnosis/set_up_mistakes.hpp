// What a diagnosis finds the sheet to say wrongly, and how to put it right.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/checks/run_poles.hpp"
#include "updating/diagnosis/diagnosis.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// Of the rungs those that are mistakes of the sheet or of the supports. Each
/// edit is to be made after those before it.
[[nodiscard]] std::vector<SetUpMistake> set_up_mistakes(
    const std::vector<Rung>& ladder, const acquisition::TestBundle& sheet);

/// "run-outlier": runs that fits leave out, since they are of another
/// structure. The probability is the least that one reading gives: of the runs'
/// usual scatter, or of one as wide as what is left; each run might have been
/// it.
/// @param runs how many were measured
/// @param error of the deck's fit without them
[[nodiscard]] std::vector<SetUpMistake> run_outliers(
    const std::vector<modal::ForeignRun>& foreign,
    std::size_t runs,
    double error);

/// Stated masses of sensors that a diagnosis contradicts: by its ladder's rungs
/// that nothing else explains as well, and where nothing is missing from the
/// model by what its candidates leave for them.
[[nodiscard]] std::vector<Finding> sensor_mass_findings(
    const Diagnosis& diagnosis, const acquisition::TestBundle& sheet);

/// "point-mislabelled at acc1 at node 6, not 8: correct
/// runs[3].sensors[0].node: 8 -> 6".
[[nodiscard]] std::string describe(const SetUpMistake& mistake);

}  // namespace tapfit::updating
